#include <fmt/format.h>

#include <cmath>
#include <string>
#include <string_view>

#include "explain/loss.hpp"
#include "explain/phrases.hpp"
#include "viewer/model/story/predicting.hpp"
#include "viewer/ui/steps/parts.hpp"
#include "viewer/ui/widgets/wrapped.hpp"

namespace glassbox {

namespace {

using story::StoryStep;

/// Follows a number printed like this: how far it can be, and is, from the truth.
std::string how_true(std::string_view printed, const Checked& number) {
    std::string text = bound(printed, number);
    if (number.known == Known::not_at_all) return text + ", its true value is not known";
    if (number.distance != 0 || may_be_zero(number)) text += ", truly " + truth(number);
    return std::isnan(number.bits_lost) ? text : text + ", " + lost(number);
}

/// A number, and beside it what is known of it, unless that is to be guessed.
void number_row(const Frame& frame, const std::string& name, const Checked& number, ImU32 color,
                bool hides_truth = false) {
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    draw_wrapped(color, name);
    ImGui::TableNextColumn();
    ImGui::PushFont(frame.fonts.mono);
    const std::string value = fmt::format("{:.17g}", number.value);
    draw_wrapped(value);
    ImGui::PopFont();
    if (hides_truth) return;
    const std::string truth = how_true(value, number);
    same_line_if_fits(ImGui::CalcTextSize(truth.c_str()).x);
    draw_wrapped(frame.palette.faint_text, truth);
}

/// Draws the result of a comparison, and whether that is true.
void draw_answer(const Frame& frame, const Checked& answer) {
    const bool holds = answer.value != 0;
    std::string text = holds ? "✓ yes" : "✗ no";
    if (answer.known == Known::not_at_all) text += "; whether it is truly so is not known";
    else if (answer.truth != answer.value) text += holds ? ", but truly no" : ", but truly yes";
    else
        text += answer.error == 0 ? ", proven by the error bounds" : ", truly so, but the error bounds cannot prove it";
    draw_wrapped(holds ? frame.palette.passed : frame.palette.failed, text);
}

void draw_step(const Frame& frame, const Event& event) {
    const std::span<const StoryStep> steps = tape_of(*frame.results.story, *event.place);
    const StoryStep& told = steps[event.place->step];
    const int count = operands(told.step.operation);
    const bool compares = is_comparison(told.step.operation),
               hidden = hides_loss(frame.state, frame.results, frame.state.step);
    if (ImGui::BeginTable("numbers", 2, ImGuiTableFlags_SizingStretchProp)) {
        ImGui::TableSetupColumn("name", 0, .33f);
        ImGui::TableSetupColumn("value", 0, .67f);
        number_row(frame, event.left, steps[told.step.left].checked, frame.palette.text);
        if (count == 2) number_row(frame, event.right, steps[told.step.right].checked, frame.palette.text);
        if (!compares)
            number_row(frame, told.name.empty() ? "result" : told.name, told.checked, frame.palette.accent, hidden);
        ImGui::EndTable();
    }
    if (compares) draw_answer(frame, told.checked);
    if (event.cancellation && !hidden)
        draw_wrapped(frame.palette.warning, fmt::format("⚠ cancellation: {:.1f} bits lost beyond those of the operands",
                                                        bits_lost_by(steps, told)));
}

}  // namespace

void draw_values(const Frame& frame, const Event& event) {
    const Sign sign = sign_of(frame, frame.state.step);
    const std::string& text = event.formula.empty() ? event.what : event.formula;
    draw_wrapped(sign.color, (*sign.text ? std::string(sign.text) + ' ' : "") + text);
    if (event.place) draw_step(frame, event);
}

}  // namespace glassbox
