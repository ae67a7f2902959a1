#include "viewer/model/state/tour.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "viewer/ui/frame/places.hpp"
#include "viewer/ui/widgets/buttons.hpp"
#include "viewer/ui/widgets/wrapped.hpp"

namespace glassbox {

namespace {

/// Beside the place where there is most room, or over it where there is none.
ImVec2 corner_beside(const Area& place, ImVec2 size) {
    const ImGuiViewport* viewport = ImGui::GetMainViewport();
    const ImVec2 least = viewport->WorkPos;
    const ImVec2 most{least.x + viewport->WorkSize.x - size.x, least.y + viewport->WorkSize.y - size.y};
    const float gap = ImGui::GetFontSize() / 2;
    ImVec2 corner{(place.from.x + place.to.x - size.x) / 2, (place.from.y + place.to.y - size.y) / 2};
    if (place.from.x - least.x >= size.x + gap) corner.x = place.from.x - size.x - gap;
    else if (most.x >= place.to.x + gap) corner.x = place.to.x + gap;
    else if (place.from.y - least.y >= size.y + gap) corner.y = place.from.y - size.y - gap;
    else if (most.y >= place.to.y + gap) corner.y = place.to.y + gap;
    return {std::clamp(corner.x, least.x, std::max(least.x, most.x)),
            std::clamp(corner.y, least.y, std::max(least.y, most.y))};
}

}  // namespace

void draw_tour(const Frame& frame, const Places& places) {
    ViewerState& state = frame.state;
    if (!state.tour) return;
    const TourStop& stop = tour()[*state.tour];
    const Area& place = area_of(places, stop.part);
    const float font = ImGui::GetFontSize();
    ImGui::GetForegroundDrawList()->AddRect(place.from, place.to, frame.palette.accent, font / 4, 0,
                                            std::max(3.f, font / 6));

    const ImGuiViewport* viewport = ImGui::GetMainViewport();
    const float width = std::min(24 * font, viewport->WorkSize.x * .9f);
    const std::string text = wrapped(stop.text, width - 2 * ImGui::GetStyle().WindowPadding.x);
    ImGui::SetNextWindowPos(corner_beside(place, {width, ImGui::CalcTextSize(text.c_str()).y + 5.5f * font}));
    ImGui::SetNextWindowSize({width, 0});
    constexpr ImGuiWindowFlags flags = ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoSavedSettings |
                                       ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
                                       ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoFocusOnAppearing;
    ImGui::PushStyleColor(ImGuiCol_WindowBg, ImGui::GetStyleColorVec4(ImGuiCol_PopupBg));
    ImGui::PushStyleColor(ImGuiCol_Border, frame.palette.accent);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, std::max(2.f, font / 9));
    ImGui::Begin("Tour", nullptr, flags);
    draw_wrapped(frame.palette.accent,
                 fmt::format("{} of {}: {}", *state.tour + 1, tour().size(), std::string(stop.title)));
    ImGui::TextUnformatted(text.c_str());
    const bool is_last = *state.tour + 1 == tour().size();
    if (button_if(*state.tour > 0, "Back")) go_back_on_tour(state);
    const char* const next = is_last ? "Done" : "Next";
    flow(next);
    if (ImGui::Button(next)) go_on_tour(state);
    flow("Leave");
    if (!is_last && ImGui::Button("Leave")) leave_tour(state);
    ImGui::End();
    ImGui::PopStyleVar();
    ImGui::PopStyleColor(2);
}

}  // namespace glassbox
