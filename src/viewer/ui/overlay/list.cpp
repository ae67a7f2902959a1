#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <utility>

#include "viewer/ui/overlay/parts.hpp"

namespace glassbox {

namespace {

bool contains(std::string_view text, std::string_view part) {
    const auto same = [](char a, char b) {
        return std::tolower(static_cast<unsigned char>(a)) == std::tolower(static_cast<unsigned char>(b));
    };
    return std::search(text.begin(), text.end(), part.begin(), part.end(), same) != text.end();
}

bool passes(const std::string& filter, const Measurement& what) {
    return contains(what.name, filter) || contains(what.explanation, filter) || contains(what.unit, filter);
}

float text_width(std::string_view text) { return ImGui::CalcTextSize(text.data(), text.data() + text.size()).x; }

/// A row: the name, the unit on the right, the explanation below. Returns whether it was chosen.
bool row(const Frame& frame, std::string_view name, std::string_view unit, std::string explanation, bool chosen) {
    const ImGuiStyle& style = ImGui::GetStyle();
    const float size = ImGui::GetFontSize(), pad = style.FramePadding.y, indent = style.FramePadding.x + size * .3f;
    const float width = ImGui::GetContentRegionAvail().x, wrap = std::max(size, width - 2 * indent);
    if (text_width(name) + text_width(unit) + size > wrap)
        explanation += fmt::format(" [{}]", std::exchange(unit, std::string_view{}));
    const ImVec2 text = ImGui::CalcTextSize(explanation.c_str(), nullptr, false, wrap);
    const float height = std::floor(size + text.y + 2 * pad);
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    ImGui::PushID(name.data(), name.data() + name.size());
    const bool clicked = ImGui::Selectable("##row", chosen, 0, {width, height});
    ImGui::PopID();
    if (!ImGui::IsItemVisible()) return clicked;

    ImDrawList& list = *ImGui::GetWindowDrawList();
    if (chosen)
        list.AddRectFilled({corner.x, corner.y}, {corner.x + size * .2f, corner.y + height}, frame.palette.accent);
    const ImVec2 at{corner.x + indent, corner.y + pad};
    list.AddText(at, chosen ? frame.palette.accent : frame.palette.text, name.data(), name.data() + name.size());
    if (!unit.empty()) {
        list.AddText({corner.x + width - indent - text_width(unit), at.y}, frame.palette.faint_text, unit.data(),
                     unit.data() + unit.size());
    }
    list.AddText(ImGui::GetFont(), size, {at.x, at.y + size}, frame.palette.faint_text, explanation.c_str(), nullptr,
                 wrap);
    return clicked;
}

void filter_box(std::string& filter) {
    std::array<char, 64> text{};
    std::copy_n(filter.begin(), std::min(filter.size(), text.size() - 1), text.begin());
    const float clear = ImGui::GetFrameHeight() + ImGui::GetStyle().ItemInnerSpacing.x;
    ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x - (filter.empty() ? 0 : clear));
    if (ImGui::InputTextWithHint("##filter", "find a measurement", text.data(), text.size())) filter = text.data();
    if (filter.empty()) return;
    ImGui::SameLine(0, ImGui::GetStyle().ItemInnerSpacing.x);
    if (ImGui::Button("×##filter", {ImGui::GetFrameHeight(), 0})) filter.clear();
}

/// Whether the choice, or the rows' height, has changed since the last call.
bool is_new_choice(const std::string& measurement) {
    ImGuiStorage& storage = *ImGui::GetStateStorage();
    const ImGuiID key = ImGui::GetID("shown");
    const float width = ImGui::GetContentRegionAvail().x;
    const std::string seen = fmt::format("{} {} {}", measurement, ImGui::GetFontSize(), width);
    const auto now = static_cast<int>(ImGui::GetID(seen.c_str()));
    const bool is_new = storage.GetInt(key) != now;
    storage.SetInt(key, now);
    return is_new;
}

}  // namespace

void draw_measurement_list(const Frame& frame) {
    ViewerState& state = frame.state;
    std::string& filter = state.overlay_page.filter;
    const float window = ImGui::GetWindowHeight(), line = ImGui::GetFontSize();
    filter_box(filter);
    ImGui::BeginChild("measurements", {0, std::max(window * .36f, 6 * line)}, true);
    const bool is_new = is_new_choice(state.overlay.measurement);
    const auto choose = [&](std::string_view name) {
        if (state.overlay.measurement != name) {  // these were for the other measurement
            state.overlay.range.reset();
            state.overlay.spacing.reset();
        }
        state.overlay.measurement = name;
    };
    const auto show = [&](std::string_view name, std::string_view unit, std::string_view explanation) {
        const bool chosen = state.overlay.measurement == name;
        if (row(frame, name.empty() ? "none" : name, unit, std::string(explanation), chosen)) choose(name);
        if (chosen && is_new) ImGui::SetScrollHereY();
    };
    if (filter.empty()) show("", "", "the picture alone");
    bool any = false;
    for (const Measurement& what : measurements())
        if (passes(filter, what)) {
            show(what.name, what.unit, what.explanation);
            any = true;
        }
    if (!any) faint(frame, "No measurement's name, unit or explanation has this in it.");
    ImGui::EndChild();
}

}  // namespace glassbox
