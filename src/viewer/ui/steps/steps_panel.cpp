#include <algorithm>
#include <string>
#include <string_view>
#include <utility>

#include "viewer/model/story/predicting.hpp"
#include "viewer/model/story/stepping.hpp"
#include "viewer/model/story/steps_now.hpp"
#include "viewer/ui/mine/mine.hpp"
#include "viewer/ui/panels.hpp"
#include "viewer/ui/steps/parts.hpp"
#include "viewer/ui/widgets/buttons.hpp"
#include "viewer/ui/widgets/wrapped.hpp"

namespace glassbox {

namespace {

struct Pane {
    StepsPane pane;
    const char* title;
    void (*draw)(const Frame&, const Event&);
};
constexpr Pane panes[] = {
    {StepsPane::source, "Source", draw_source},
    {StepsPane::formula, "Formula", draw_formula},
    {StepsPane::losses, "Losses", [](const Frame& frame, const Event&) { draw_losses(frame); }},
    {StepsPane::nudge, "Nudge", [](const Frame& frame, const Event&) { draw_nudge(frame); }},
};

/// Where the present number comes from, and back.
void draw_ways(const Frame& frame) {
    const Stepping& stepping = frame.state.stepping;
    if (toggle("Only what feeds it (v)", stepping.fed.has_value()))
        show_only_feeding(frame.state, frame.results, !stepping.fed);
    tip("Hide all other steps");
    flow("Back (j)");
    if (button_if(!stepping.back.empty(), "Back (j)")) jump_back(frame.state, frame.results);
    flow("Forth (J)");
    if (button_if(!stepping.forth.empty(), "Forth (J)")) jump_forth(frame.state, frame.results);
}

void draw_pane(const Frame& frame, const Event& event, float height) {
    StepsPane& shown = frame.state.stepping.pane;
    const float top = ImGui::GetCursorPosY();
    for (const Pane& pane : panes) {
        if (&pane != panes) flow(pane.title, ImGui::GetStyle().ItemInnerSpacing.x);
        if (toggle(pane.title, pane.pane == shown)) shown = pane.pane;
    }
    ImGui::BeginChild("pane", {0, std::max(height - (ImGui::GetCursorPosY() - top), ImGui::GetFontSize())});
    for (const Pane& pane : panes)
        if (pane.pane == shown) pane.draw(frame, event);
    ImGui::EndChild();
}

/// Whose steps these are, and what is to be said of the learner's; where there is a learner.
void draw_whose_steps(const Frame& frame) {
    ViewerState& state = frame.state;
    if (!state.mine.chosen && !state.mine.is_stepped) return;
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted("Steps of");
    ImGui::SameLine();
    if (toggle("ours", !state.mine.is_stepped)) step_mine(state, false);
    tip("Go through what our code computes (/)");
    ImGui::SameLine(0, ImGui::GetStyle().ItemInnerSpacing.x);
    if (toggle("mine", state.mine.is_stepped)) step_mine(state, true);
    tip("Go through what your own code computes (/)");
    if (!state.mine.is_stepped) return;
    const std::string lessons = mine_title(state).substr(std::string_view("mine: ").size());
    ImGui::SameLine();
    ImGui::TextDisabled("%s", fitting(lessons, ImGui::GetContentRegionAvail().x).c_str());
    draw_recording(frame);
}

void draw_no_steps(const Frame& frame) {
    const ViewerState& state = frame.state;
    const bool is_mine = state.mine.is_stepped;
    const bool will_come = is_mine ? frame.results.mine_steps.update.words.empty() && state.mine.problem.empty() : true;
    draw_wrapped(frame.palette.faint_text,
                 !state.pinned ? "Click a pixel: everything that is computed for it is listed here, step by step, with "
                                 "the source that asked for it."
                 : will_come   ? "The steps are being computed…"
                               : "");
}

/// The parts share the height of the page, whatever is in them, so that nothing jumps from step to step; but none gets
/// too low to be read: then the page scrolls.
void draw_timeline_page(const Frame& frame) {
    const float line = ImGui::GetTextLineHeightWithSpacing(), room = ImGui::GetContentRegionAvail().y;
    draw_transport(frame);
    if (!frame.state.mine.is_stepped) draw_predict(frame);
    draw_hidden(frame);
    // A click in one part goes to another event, which the next part is about.
    const auto event = [&]() -> const Event& {
        return steps_now(frame.state, frame.results).timeline[frame.state.step];
    };
    draw_event_list(frame, std::max(4.5f * line, .18f * room));
    float* const size = ImGui::GetStateStorage()->GetFloatRef(ImGui::GetID("text size"), ImGui::GetFontSize());
    const float top = ImGui::GetWindowPos().y, bottom = top + ImGui::GetWindowHeight();
    const bool in_sight = ImGui::GetItemRectMin().y >= top && ImGui::GetItemRectMax().y <= bottom;
    if (std::exchange(*size, ImGui::GetFontSize()) != ImGui::GetFontSize() && !in_sight) ImGui::SetScrollHereY();
    ImGui::BeginChild("values", {0, std::max(8.5f * line, .24f * room)}, true);
    draw_values(frame, event());
    ImGui::EndChild();
    draw_ways(frame);
    draw_pane(frame, event(), std::max(10 * line, ImGui::GetContentRegionAvail().y));
}

}  // namespace

void draw_steps(const Frame& frame) {
    ViewerState& state = frame.state;
    const std::span<const Event> timeline = steps_shown(state, frame.results);
    draw_looked_at(frame);
    draw_whose_steps(frame);
    const float below = watch_height(frame);
    ImGui::BeginChild("timeline page", {0, std::max(ImGui::GetContentRegionAvail().y - below, ImGui::GetFontSize())});
    if (timeline.empty() || !steps_now(frame.state, frame.results).story) {
        draw_no_steps(frame);
    } else {
        state.step = std::min(state.step, timeline.size() - 1);
        draw_timeline_page(frame);
    }
    ImGui::EndChild();
    draw_watch(frame);
}

}  // namespace glassbox
