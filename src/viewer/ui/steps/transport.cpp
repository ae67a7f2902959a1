#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "viewer/model/state/playing.hpp"
#include "viewer/model/story/predicting.hpp"
#include "viewer/model/story/stepping.hpp"
#include "viewer/model/story/steps_now.hpp"
#include "viewer/ui/steps/parts.hpp"
#include "viewer/ui/widgets/buttons.hpp"
#include "viewer/ui/widgets/wrapped.hpp"

namespace glassbox {

namespace {

enum class Icon { first, back, play, pause, forward, last };

/// Drawn as shapes, because the fonts do not have these signs.
void draw_icon(Icon icon, ImVec2 middle, float r, ImU32 color) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const auto triangle = [&](float from, float to) {  // its tip at `to`
        list.AddTriangleFilled({middle.x + from * r, middle.y - r * .8f}, {middle.x + from * r, middle.y + r * .8f},
                               {middle.x + to * r, middle.y}, color);
    };
    const auto bar = [&](float from, float to) {
        list.AddRectFilled({middle.x + from * r, middle.y - r * .8f}, {middle.x + to * r, middle.y + r * .8f}, color);
    };
    switch (icon) {
        case Icon::first:
            bar(-1, -.7f);
            triangle(.9f, -.6f);
            return;
        case Icon::back:
            triangle(.2f, -1);
            bar(.5f, .8f);
            return;
        case Icon::play:
            return triangle(-.7f, 1);
        case Icon::pause:
            bar(-.7f, -.2f);
            bar(.2f, .7f);
            return;
        case Icon::forward:
            bar(-.8f, -.5f);
            triangle(-.2f, 1);
            return;
        case Icon::last:
            triangle(-.9f, .6f);
            bar(.7f, 1);
            return;
    }
}

bool icon_button(const char* id, Icon icon, const char* what) {
    const float size = ImGui::GetFrameHeight();
    const bool clicked = ImGui::Button(id, {1.35f * size, size});
    const ImVec2 from = ImGui::GetItemRectMin(), to = ImGui::GetItemRectMax();
    draw_icon(icon, {(from.x + to.x) / 2, (from.y + to.y) / 2}, size * .27f, ImGui::GetColorU32(ImGuiCol_Text));
    tip(what);
    return clicked;
}

void buttons(const Frame& frame) {
    ViewerState& state = frame.state;
    const auto to = [&](StepTo where) { go(state, frame.results, where); };
    const auto beside = [] { same_line_if_fits(ImGui::GetItemRectSize().x); };  // all are equally wide
    if (icon_button("##first", Icon::first, "To the first step (Home)")) to(StepTo::first);
    beside();
    if (icon_button("##back", Icon::back, "A step back ([)")) to(StepTo::back);
    beside();
    if (icon_button("##play", state.playing ? Icon::pause : Icon::play,
                    state.playing ? "Pause (Space)" : "Play (Space)"))
        play_or_pause(state, frame.results);
    beside();
    if (icon_button("##forward", Icon::forward, "A step forward (])")) to(StepTo::forward);
    beside();
    if (icon_button("##last", Icon::last, "To the last step (End)")) to(StepTo::last);

    const auto press = [](const char* label, const char* what) {
        same_line_if_fits(ImGui::CalcTextSize(label).x + 2 * ImGui::GetStyle().FramePadding.x);
        const bool clicked = ImGui::Button(label);
        tip(what);
        return clicked;
    };
    if (press("Into", "Into what the line of the call stack calls (i)")) step_into(state, frame.results);
    if (press("Over", "Over that line (o)")) step_over(state, frame.results);
    if (press("Out", "Out of the function (u)")) step_out(state, frame.results);
    if (press("no", "To the next condition that does not hold, or surface that is missed (n)")) to(StepTo::next_no);
    if (press("✗", "To what failed next: a wrong answer, a number too large (x)")) to(StepTo::next_failed);
    if (press("⚠", "To the next sum or difference that loses a bit or more beyond those of its operands (c)"))
        to(StepTo::next_cancellation);
}

/// All events on a line: above it what failed, below it the cancellations.
void slider(const Frame& frame) {
    ViewerState& state = frame.state;
    const std::span<const Event> events = steps_shown(state, frame.results);
    const std::vector<bool> kept = events_kept(state, frame.results);
    const ImVec2 from = ImGui::GetCursorScreenPos();
    const float width = ImGui::GetContentRegionAvail().x, height = ImGui::GetFrameHeight(), pad = height / 3;
    ImGui::InvisibleButton("##steps", {std::max(width, 1.f), height});
    const bool active = ImGui::IsItemActive(), hovered = ImGui::IsItemHovered();
    const auto last = static_cast<float>(std::max<std::size_t>(events.size(), 2) - 1);
    const float length = std::max(width - 2 * pad, 1.f), middle = from.y + height / 2;
    const auto x_of = [&](std::size_t step) { return from.x + pad + length * static_cast<float>(step) / last; };
    const float part = std::clamp((ImGui::GetIO().MousePos.x - from.x - pad) / length, 0.f, 1.f);
    const std::size_t pointed = std::min(static_cast<std::size_t>(std::lround(part * last)), events.size() - 1);
    if (active) {
        state.playing = false;
        state.step = pointed;
    }
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float thick = std::max(1.f, height / 16);
    list.AddRectFilled({from.x, from.y}, {from.x + width, from.y + height}, ImGui::GetColorU32(ImGuiCol_FrameBg),
                       ImGui::GetStyle().FrameRounding);
    for (std::size_t i = 0; i < events.size(); ++i) {
        const float x = x_of(i);
        if (!kept.empty() && !kept[i]) continue;
        if (events[i].failed) list.AddLine({x, from.y + thick}, {x, middle - thick}, frame.palette.failed, thick);
        if (events[i].cancellation && !hides_loss(state, frame.results, i))
            list.AddLine({x, middle + thick}, {x, from.y + height - thick}, frame.palette.warning, thick);
    }
    list.AddLine({x_of(0), middle}, {from.x + pad + length, middle}, frame.palette.line, thick);
    list.AddLine({x_of(0), middle}, {x_of(state.step), middle}, frame.palette.accent, 2 * thick);
    list.AddCircleFilled({x_of(state.step), middle}, height * (active || hovered ? .32f : .26f), frame.palette.accent);
    if (hovered && !active) ImGui::SetTooltip("%s", events[pointed].what.c_str());
}

void counts(const Frame& frame) {
    const std::span<const Event> events = steps_shown(frame.state, frame.results);
    const auto failed = std::count_if(events.begin(), events.end(), [](const Event& e) { return e.failed; });
    const auto denied = std::count_if(events.begin(), events.end(), says_no);
    auto lost = std::count_if(events.begin(), events.end(), [](const Event& e) { return e.cancellation; });
    if (!events.empty() && hides_loss(frame.state, frame.results, events.size() - 1)) --lost;
    ImGui::AlignTextToFramePadding();
    const bool is_all = events.size() == steps_now(frame.state, frame.results).timeline.size();
    ImGui::TextUnformatted(
        fmt::format("{} of {}{}", frame.state.step + 1, events.size(), is_all ? "" : " so far").c_str());
    // As if at the last step, so that no line breaks elsewhere while one steps.
    const float longer = ImGui::CalcTextSize(std::to_string(events.size()).c_str()).x -
                         ImGui::CalcTextSize(std::to_string(frame.state.step + 1).c_str()).x;
    const auto piece = [&](const std::string& text, ImU32 color) {
        same_line_if_fits(ImGui::CalcTextSize(text.c_str()).x + longer);
        ImGui::PushStyleColor(ImGuiCol_Text, color);
        ImGui::TextUnformatted(text.c_str());
        ImGui::PopStyleColor();
    };
    piece(fmt::format(" {} no", denied), frame.palette.faint_text);
    piece(fmt::format(" ✗ {} failed", failed), frame.palette.failed);
    piece(fmt::format(" ⚠ {} cancelled", lost), frame.palette.warning);
    const float wide = 7 * ImGui::GetFontSize();
    same_line_if_fits(wide + longer);
    const float left = ImGui::GetContentRegionAvail().x - wide;
    if (left > 0) ImGui::SetCursorPosX(ImGui::GetCursorPosX() + left);
    ImGui::SetNextItemWidth(std::min(wide, ImGui::GetContentRegionAvail().x));
    constexpr double least = .5, most = 200;
    ImGui::SliderScalar("##speed", ImGuiDataType_Double, &frame.state.steps_per_second, &least, &most, "%.3g steps/s",
                        ImGuiSliderFlags_Logarithmic);
    frame.state.steps_per_second = std::clamp(frame.state.steps_per_second, least, most);
    tip("How fast Play goes");
}

}  // namespace

void same_line_if_fits(float width) {
    ImGui::SameLine(0, ImGui::GetStyle().ItemInnerSpacing.x);
    if (ImGui::GetContentRegionAvail().x < width) ImGui::NewLine();
}

void draw_hidden(const Frame& frame) {
    const std::string hidden = hidden_in_words(frame.state, frame.results);
    if (hidden.empty()) return;
    draw_wrapped(frame.palette.warning, hidden);
    flow("Show all (v)");
    if (ImGui::Button("Show all (v)")) show_only_feeding(frame.state, frame.results, false);
}

void draw_transport(const Frame& frame) {
    buttons(frame);
    slider(frame);
    counts(frame);
}

}  // namespace glassbox
