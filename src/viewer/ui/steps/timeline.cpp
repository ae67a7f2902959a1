#include <algorithm>
#include <string>
#include <vector>

#include "viewer/model/story/predicting.hpp"
#include "viewer/model/story/stepping.hpp"
#include "viewer/model/story/steps_now.hpp"
#include "viewer/ui/steps/parts.hpp"
#include "viewer/ui/widgets/wrapped.hpp"

namespace glassbox {

namespace {

/// A row of the list: an event, or the heading over it.
struct Row {
    std::size_t event;
    bool heading;
};

/// `kept` tells which events are shown, as of `events_kept`.
std::vector<Row> rows_of(std::span<const Event> events, const std::vector<bool>& kept) {
    std::vector<Row> rows;
    rows.reserve(events.size() + 32);
    const Event* before = nullptr;
    for (std::size_t i = 0; i < events.size(); ++i) {
        if (!kept.empty() && !kept[i]) continue;
        if (!before || events[i].group != before->group) rows.push_back({i, true});
        rows.push_back({i, false});
        before = &events[i];
    }
    return rows;
}

void draw_event(const Frame& frame, std::size_t number) {
    const Event& event = steps_now(frame.state, frame.results).timeline[number];
    const float em = ImGui::GetFontSize(), left = ImGui::GetCursorPosX(), width = ImGui::GetContentRegionAvail().x;
    const bool current = number == frame.state.step;
    if (ImGui::Selectable("##event", current)) {
        frame.state.step = number;
        frame.state.playing = false;
    }
    const Sign sign = sign_of(frame, number);
    ImGui::SameLine(left + .2f * em);
    ImGui::PushStyleColor(ImGuiCol_Text, current ? frame.palette.text : sign.color);
    ImGui::TextUnformatted(sign.text);
    ImGui::PopStyleColor();
    const float first = left + 1.7f * em;
    const bool both = event.place && !event.formula.empty() && width > 22 * em;  // else the formula is below only
    const float middle = both ? left + .48f * width : left + width;
    ImGui::SameLine(first);
    ImGui::TextUnformatted(fitting(event.what, middle - first - .4f * em).c_str());
    if (!both) return;
    ImGui::SameLine(middle);
    ImGui::PushStyleColor(ImGuiCol_Text, current ? frame.palette.text : frame.palette.faint_text);
    ImGui::TextUnformatted(fitting(event.formula, left + width - middle).c_str());
    ImGui::PopStyleColor();
}

/// Scrolls the current event to the middle when it has changed, or what is seen of the list has.
void follow(const Frame& frame, const std::vector<Row>& rows, float height) {
    ImGuiStorage* const storage = ImGui::GetStateStorage();
    const ImGuiID id = ImGui::GetID("shown");
    const auto step = static_cast<int>(frame.state.step);
    const int serial =
        static_cast<int>(2 * steps_now(frame.state, frame.results).story_serial) + frame.state.stepping.fed.has_value();
    const ImGuiID story_id = ImGui::GetID("story");
    const ImGuiID height_id = ImGui::GetID("height");
    const ImGuiID line_id = ImGui::GetID("line");
    const float line = ImGui::GetTextLineHeightWithSpacing();
    if (storage->GetInt(id, -1) == step && storage->GetInt(story_id, -1) == serial &&
        storage->GetFloat(height_id) == height && storage->GetFloat(line_id) == line)
        return;
    storage->SetFloat(height_id, height);
    storage->SetFloat(line_id, line);
    storage->SetInt(id, step);
    storage->SetInt(story_id, serial);
    const auto at = std::find_if(rows.begin(), rows.end(),
                                 [&](const Row& row) { return !row.heading && row.event == frame.state.step; });
    ImGui::SetScrollY(std::max(0.f, (static_cast<float>(at - rows.begin()) + .5f) * line - height / 2));
}

}  // namespace

Sign sign_of(const Frame& frame, std::size_t step) {
    const Event& event = steps_now(frame.state, frame.results).timeline[step];
    if (event.failed) return {"✗", frame.palette.failed};
    if (event.holds) return *event.holds ? Sign{"✓", frame.palette.passed} : Sign{"no", frame.palette.faint_text};
    if (event.cancellation && !hides_loss(frame.state, frame.results, step)) return {"⚠", frame.palette.warning};
    return {"", frame.palette.text};
}

void draw_event_list(const Frame& frame, float height) {
    const std::vector<Row> rows =
        rows_of(steps_shown(frame.state, frame.results), events_kept(frame.state, frame.results));
    ImGui::BeginChild("events", {0, height}, true);
    follow(frame, rows, ImGui::GetWindowHeight());
    ImGuiListClipper clipper;
    clipper.Begin(static_cast<int>(rows.size()), ImGui::GetTextLineHeightWithSpacing());
    while (clipper.Step())
        for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i) {
            const Row& row = rows[static_cast<std::size_t>(i)];
            ImGui::PushID(i);
            if (row.heading) {
                ImGui::PushStyleColor(ImGuiCol_Text, frame.palette.accent);
                ImGui::TextUnformatted(fitting(steps_now(frame.state, frame.results).timeline[row.event].group,
                                               ImGui::GetContentRegionAvail().x)
                                           .c_str());
                ImGui::PopStyleColor();
            } else draw_event(frame, row.event);
            ImGui::PopID();
        }
    ImGui::EndChild();
}

}  // namespace glassbox
