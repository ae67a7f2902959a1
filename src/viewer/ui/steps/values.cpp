#include <fmt/format.h>

#include <cmath>
#include <optional>
#include <string>
#include <string_view>

#include "explain/loss.hpp"
#include "explain/phrases.hpp"
#include "viewer/model/story/predicting.hpp"
#include "viewer/model/story/stepping.hpp"
#include "viewer/model/story/steps_now.hpp"
#include "viewer/ui/steps/parts.hpp"
#include "viewer/ui/widgets/buttons.hpp"
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

/// The same of a step's result, with what of it is its own loss.
std::string how_true_and_why(std::string_view printed, const Checked& number) {
    const bool told = number.own_loss > 0 || number.inherited_loss > 0;
    return how_true(printed, number) + (told ? ": " + own_and_inherited(number) : "");
}

/// How a number's name looks, and where a click on it leads.
struct Look {
    ImU32 color;
    std::optional<std::size_t> made_by = {};
    const char* tip = "";
};

/// Draws a name that a click follows.
void draw_link(const Frame& frame, const std::string& name, const Look& look) {
    draw_wrapped(look.color, name);
    if (!look.made_by) return;
    const ImVec2 from = ImGui::GetItemRectMin(), to = ImGui::GetItemRectMax();
    ImGui::GetWindowDrawList()->AddLine({from.x, to.y}, to, look.color);
    if (!ImGui::IsItemHovered()) return;
    ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
    ImGui::SetTooltip("%s", look.tip);
    if (ImGui::IsMouseClicked(0)) jump(frame.state, frame.results, *look.made_by);
}

/// Draws a number, and below it what is known of it.
void draw_number(const Frame& frame, const std::string& name, const Checked& number, const Look& look,
                 std::string (*known)(std::string_view, const Checked&)) {
    draw_link(frame, (look.made_by ? "← " : "") + name + " =", look);
    const std::string value = with_minus(fmt::format("{:.17g}", number.value));
    ImGui::PushFont(frame.fonts.mono);
    same_line_if_fits(ImGui::CalcTextSize(value.c_str()).x + ImGui::GetFontSize());
    draw_wrapped(value);
    ImGui::PopFont();
    if (!known) return;
    ImGui::Indent(ImGui::GetFontSize());
    draw_wrapped(frame.palette.faint_text, known(value, number));
    ImGui::Unindent(ImGui::GetFontSize());
}

/// Draws the result of a comparison, and whether that is true.
void draw_answer(const Frame& frame, const Checked& answer) {
    const bool holds = answer.value != 0;
    const bool wrong = answer.known != Known::not_at_all && answer.truth != answer.value;
    std::string text = wrong ? (holds ? "✗ yes" : "✗ no") : holds ? "✓ yes" : "no";
    if (answer.known == Known::not_at_all) text += "; whether it is truly so is not known";
    else if (wrong) text += holds ? ", but truly no: this failed" : ", but truly yes: this failed";
    else
        text += answer.error == 0 ? ", proven by the error bounds" : ", truly so, but the error bounds cannot prove it";
    draw_wrapped(wrong ? frame.palette.failed : holds ? frame.palette.passed : frame.palette.text, text);
}

void draw_step(const Frame& frame, const Event& event) {
    const std::span<const StoryStep> steps = tape_of(*steps_now(frame.state, frame.results).story, *event.place);
    const StoryStep& told = steps[event.place->step];
    const int count = operands(told.step.operation);
    const bool compares = is_comparison(told.step.operation),
               hidden = hides_loss(frame.state, frame.results, frame.state.step);
    const auto operand = [&](std::optional<std::size_t> made_by, const char* what) {
        return Look{made_by ? frame.palette.accent : frame.palette.text, made_by, what};
    };
    if (compares) draw_answer(frame, told.checked);
    else
        draw_number(frame, told.name.empty() ? "result" : told.name, told.checked, {frame.palette.text},
                    hidden ? nullptr : how_true_and_why);
    if (event.cancellation && !hidden)
        draw_wrapped(frame.palette.warning, fmt::format("⚠ cancellation: {:.1f} bits lost beyond those of the operands",
                                                        bits_lost_by(steps, told)));
    const auto name = [&](StepNumber number, const std::string& written) {
        return steps[number].step.operation == Operation::constant ? "constant" : written;
    };
    draw_number(frame, name(told.step.left, event.left), steps[told.step.left].checked,
                operand(event.left_made_by, "To the step that made it (e)"), how_true);
    if (count == 2)
        draw_number(frame, name(told.step.right, event.right), steps[told.step.right].checked,
                    operand(event.right_made_by, "To the step that made it (Shift+e)"), how_true);
}

}  // namespace

void draw_values(const Frame& frame, const Event& event) {
    const Sign sign = sign_of(frame, frame.state.step);
    const bool no = says_no(event) && !event.failed;
    std::string text(sign.text);
    if (!text.empty()) text += no ? ": " : " ";
    text += event.formula.empty() ? event.what : event.formula;
    draw_wrapped(no ? frame.palette.text : sign.color, text);
    if (event.place) draw_step(frame, event);
}

}  // namespace glassbox
