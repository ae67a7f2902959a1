#include <algorithm>

#include "viewer/model/story/predicting.hpp"
#include "viewer/ui/mine/mine.hpp"
#include "viewer/ui/panels.hpp"
#include "viewer/ui/steps/parts.hpp"

namespace glassbox {

namespace {

/// The parts share the available height, but none gets too low to be read: then the page scrolls.
void draw_timeline_page(const Frame& frame) {
    draw_transport(frame);
    draw_predict(frame);
    const Event& event = frame.results.timeline[frame.state.step];
    const float line = ImGui::GetTextLineHeightWithSpacing(), room = ImGui::GetContentRegionAvail().y;
    draw_event_list(frame, std::max(6 * line, .3f * room));
    draw_values(frame, event);
    const float left = ImGui::GetContentRegionAvail().y;
    const float lesson = std::min(lesson_height(frame, event), std::max(6 * line, left / 2));
    draw_source(frame, event, std::max(7 * line, left - lesson));
    draw_lesson(frame, event, lesson);
}

}  // namespace

void draw_steps(const Frame& frame) {
    ViewerState& state = frame.state;
    const std::span<const Event> timeline = steps_shown(state, frame.results);
    draw_looked_at(frame);
    const float below = watch_height(frame);
    ImGui::BeginChild("timeline page", {0, std::max(ImGui::GetContentRegionAvail().y - below, ImGui::GetFontSize())});
    if (timeline.empty() || !frame.results.story) {
        ImGui::PushTextWrapPos(0);
        ImGui::TextDisabled("%s", state.pinned
                                      ? "The steps are being computed…"
                                      : "Click a pixel: everything that is computed for it is listed here, step "
                                        "by step, with the source that asked for it.");
        ImGui::PopTextWrapPos();
    } else {
        state.step = std::min(state.step, timeline.size() - 1);
        draw_timeline_page(frame);
    }
    ImGui::EndChild();
    draw_watch(frame);
}

}  // namespace glassbox
