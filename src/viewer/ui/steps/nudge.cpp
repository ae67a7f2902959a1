#include "explain/nudge.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>

#include "explain/phrases.hpp"
#include "explain/words.hpp"
#include "viewer/model/story/stepping.hpp"
#include "viewer/ui/steps/parts.hpp"
#include "viewer/ui/widgets/buttons.hpp"
#include "viewer/ui/widgets/wrapped.hpp"

namespace glassbox {

namespace {

/// How far the next nudge goes, and the ways back.
void draw_how_far(const Frame& frame) {
    Stepping& stepping = frame.state.stepping;
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted("by");
    for (const int by : {1, 10, 100}) {
        const std::string label = fmt::format("{} ulp", by);
        flow(label.c_str());
        if (toggle(label.c_str(), stepping.nudge_by == by)) stepping.nudge_by = by;
    }
    flow("Undo");
    if (button_if(!stepping.nudges.empty(), "Undo")) undo_nudge(frame.state, frame.results);
    flow("Reset");
    if (button_if(!stepping.nudges.empty(), "Reset")) reset_nudges(frame.state);
}

/// An input with its two buttons, and how far it has been moved.
void draw_input(const Frame& frame, const NudgedInput& input) {
    const float small = ImGui::GetFrameHeight(), gap = ImGui::GetStyle().ItemInnerSpacing.x;
    ImGui::PushID(input.name.c_str());
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(input.name.c_str());
    if (ImGui::IsItemHovered())
        ImGui::SetTooltip("%s\nnow %s", with_minus(fmt::format("{:.17g}", input.before)).c_str(),
                          with_minus(fmt::format("{:.17g}", input.after)).c_str());
    ImGui::SameLine(0, gap);
    if (ImGui::Button("−", {small, 0})) nudge(frame.state, frame.results, input.name, -frame.state.stepping.nudge_by);
    ImGui::SameLine(0, gap / 2);
    if (ImGui::Button("+", {small, 0})) nudge(frame.state, frame.results, input.name, frame.state.stepping.nudge_by);
    if (input.by != 0) {
        ImGui::SameLine(0, gap);
        ImGui::PushStyleColor(ImGuiCol_Text, frame.palette.accent);
        ImGui::TextUnformatted(with_minus(fmt::format("{:+}", input.by)).c_str());
        ImGui::PopStyleColor();
    }
    ImGui::PopID();
}

/// The inputs, each vector in a row of its own if it fits.
void draw_inputs(const Frame& frame, const std::vector<NudgedInput>& inputs) {
    const float left = ImGui::GetCursorPosX(), room = ImGui::GetContentRegionAvail().x;
    float widest = 0, moved = ImGui::CalcTextSize("+9").x;
    for (const NudgedInput& input : inputs) {
        widest = std::max(widest, ImGui::CalcTextSize(input.name.c_str()).x);
        moved = std::max(moved, ImGui::CalcTextSize(with_minus(fmt::format("{:+}", input.by)).c_str()).x);
    }
    const float cell = widest + 2 * ImGui::GetFrameHeight() + moved + 4 * ImGui::GetStyle().ItemInnerSpacing.x;
    const auto columns = static_cast<int>(std::clamp(room / cell, 1.f, 3.f));
    int column = 0;
    for (std::size_t i = 0; i < inputs.size(); ++i) {
        const bool begins = i == 0 || inputs[i].name[0] != inputs[i - 1].name[0] || column == columns;
        if (begins) column = 0;
        else ImGui::SameLine(left + cell * static_cast<float>(column));
        draw_input(frame, inputs[i]);
        ++column;
    }
}

std::string in_words(const std::optional<Answer>& answer) {
    if (!answer) return "not asked";
    std::string text = fmt::format("{}: {}", short_number(answer->number.value), answer->holds ? "yes" : "no");
    if (answer->truly && *answer->truly != answer->holds) text += answer->holds ? ", truly no" : ", truly yes";
    return text;
}

/// "⚠ flips: b ≥ 0"; "no answer flips".
std::string flips_in_words(const std::vector<NudgedAnswer>& answers) {
    std::string text;
    for (const NudgedAnswer& answer : answers)
        if (answer.flips()) text += (text.empty() ? "⚠ flips: " : ", ") + answer.condition;
    return text.empty() ? "no answer flips" : text;
}

void draw_answers(const Frame& frame, const std::vector<NudgedAnswer>& answers) {
    if (!ImGui::BeginTable("answers", 3, ImGuiTableFlags_SizingStretchProp)) return;
    ImGui::TableSetupColumn("condition", 0, .3f);
    ImGui::TableSetupColumn("before", 0, .35f);
    ImGui::TableSetupColumn("after", 0, .35f);
    ImGui::TableHeadersRow();
    for (const NudgedAnswer& answer : answers) {
        ImGui::TableNextRow();
        if (answer.flips()) ImGui::TableSetBgColor(ImGuiTableBgTarget_RowBg0, ImGui::GetColorU32(ImGuiCol_Header));
        const ImU32 color = frame.palette.text;
        ImGui::TableNextColumn();
        draw_wrapped(color, answer.condition);
        ImGui::TableNextColumn();
        draw_wrapped(color, in_words(answer.before));
        ImGui::TableNextColumn();
        draw_wrapped(color, (answer.flips() ? "⚠ flips: " : "") + in_words(answer.after));
    }
    ImGui::EndTable();
}

}  // namespace

void draw_nudge(const Frame& frame) {
    const std::optional<std::size_t> row = row_to_nudge(frame.state, frame.results);
    if (!row)
        return draw_wrapped(
            frame.palette.faint_text,
            frame.state.mine.is_stepped ? "Numbers are nudged in our test: choose the steps of ours above."
            : frame.state.predicting.on ? "Once you have seen this surface's verdict, its numbers can be nudged."
                                        : "Step to the test of a surface: its numbers can be nudged.");
    const std::shared_ptr<const Nudged> now = frame.state.stepping.nudged;  // a click changes what the state has
    if (!now) return;
    const story::Surface& surface = frame.results.story->surfaces[frame.state.stepping.nudged_row];
    const bool changed = now->before != now->after;
    draw_wrapped(changed ? frame.palette.warning : frame.palette.text,
                 fmt::format("{}surface {}, {}: {}{}", changed ? "⚠ " : "", surface.number, word(surface.kind),
                             in_words(now->before), changed ? "; now " + in_words(now->after) : std::string()));
    draw_how_far(frame);
    const bool any = std::ranges::any_of(now->answers, &NudgedAnswer::flips);
    draw_wrapped(any ? frame.palette.warning : frame.palette.faint_text, flips_in_words(now->answers));
    ImGui::BeginChild("nudged", {0, 0}, true);
    draw_inputs(frame, now->inputs);
    draw_answers(frame, now->answers);
    ImGui::EndChild();
}

}  // namespace glassbox
