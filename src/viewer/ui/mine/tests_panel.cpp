#include <fmt/format.h>

#include <algorithm>
#include <span>

#include "viewer/ui/mine/mine.hpp"
#include "viewer/ui/overlay/parts.hpp"
#include "viewer/ui/steps/parts.hpp"
#include "viewer/ui/widgets/buttons.hpp"
#include "viewer/ui/widgets/wrapped.hpp"

namespace glassbox {

namespace {

using learn::ToldCase;
using learn::ToldFunction;
using learn::ToldRow;
using learn::ToldTests;

/// ✓ it passes, ✗ it fails, … it waits for another function, · it is not written, or nothing is known of it.
Sign sign_of(const Frame& frame, learn::State state) {
    const Palette& palette = frame.palette;
    switch (state) {
        case learn::State::passed:
            return {"✓", palette.passed};
        case learn::State::failing:
            return {"✗", palette.failed};
        case learn::State::waiting:
            return {"…", palette.faint_text};
        case learn::State::not_written:
            return {"☐", palette.warning};
        case learn::State::unknown:
            break;
    }
    return {"·", palette.faint_text};
}

Sign sign_of(const Frame& frame, const ToldTests& tests) {
    switch (tests.stand) {
        case ToldTests::Stand::running:
            return {"…", frame.palette.accent};
        case ToldTests::Stand::not_there:
            return {"⚠", frame.palette.warning};
        case ToldTests::Stand::does_not_compile:
            break;
        case ToldTests::Stand::done:
            if (tests.passed) return {"✓", frame.palette.passed};
    }
    return {"✗", frame.palette.failed};
}

void text_in(ImU32 color, const std::string& text) {
    ImGui::PushStyleColor(ImGuiCol_Text, color);
    ImGui::TextUnformatted(text.c_str());
    ImGui::PopStyleColor();
}

void draw_rows(const Frame& frame, const char* id, std::span<const ToldRow> rows) {
    if (rows.empty() || !ImGui::BeginTable(id, 2, ImGuiTableFlags_SizingFixedFit)) return;
    ImGui::TableSetupColumn("name");
    ImGui::TableSetupColumn("value", ImGuiTableColumnFlags_WidthStretch);
    for (const auto& [name, value] : rows) {
        ImGui::TableNextRow();
        ImGui::TableNextColumn();
        text_in(frame.palette.faint_text, name);
        ImGui::TableNextColumn();
        const bool tells = name == "expected" || name == "got";
        draw_wrapped(name == "got" ? frame.palette.failed : tells ? frame.palette.passed : frame.palette.text, value);
    }
    ImGui::EndTable();
}

void draw_paragraphs(const Frame& frame, const std::vector<ToldRow>& paragraphs) {
    for (const auto& [heading, text] : paragraphs) {
        if (!heading.empty()) text_in(frame.palette.accent, heading);
        draw_wrapped(text);
    }
}

void draw_case(const Frame& frame, const ToldCase& test) {
    const bool chosen = test.name == frame.state.mine.test;
    const float em = ImGui::GetFontSize(), left = ImGui::GetCursorPosX(), width = ImGui::GetContentRegionAvail().x;
    if (ImGui::Selectable("##test", chosen)) look_at(frame.state, test);
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", test.name.c_str());
    const auto [sign, color] = sign_of(frame, test.state);
    ImGui::SameLine(left + em);
    text_in(color, sign);
    const std::string scalars = fmt::format("{}", fmt::join(test.scalars, ", "));
    const float room = ImGui::CalcTextSize(scalars.c_str()).x, first = left + 2.2f * em;
    const bool both = width - first - room > 8 * em;
    ImGui::SameLine(first);
    ImGui::TextUnformatted(fitting(test.name, width - first - (both ? room + em : 0)).c_str());
    if (!both) return;
    ImGui::SameLine(left + width - room);
    text_in(frame.palette.faint_text, scalars);
}

void draw_function(const Frame& frame, const ToldFunction& function) {
    const auto [sign, color] = sign_of(frame, function.state);
    text_in(color, sign);
    ImGui::SameLine(1.4f * ImGui::GetFontSize());
    text_in(frame.palette.accent, function.name.empty() ? "all of it together" : function.name);
    if (function.waits_for.empty()) return;
    ImGui::SameLine();
    text_in(frame.palette.faint_text, fmt::format("waits for `{}`", function.waits_for));
}

/// Whether it is not the text that was shown here in the last frame: then it is scrolled to.
bool is_newly_shown(const std::string& text) {
    ImGuiStorage* const storage = ImGui::GetStateStorage();
    const ImGuiID key = ImGui::GetID("shown"), now = ImGui::GetID(text.c_str());
    const bool is_new = storage->GetInt(key) != static_cast<int>(now);
    storage->SetInt(key, static_cast<int>(now));
    return is_new;
}

void draw_list(const Frame& frame, const ToldTests& tests, float height) {
    ImGui::BeginChild("tests", {0, height}, true);
    const bool scrolls = is_newly_shown(frame.state.mine.test);
    for (const ToldFunction& function : tests.functions) {
        ImGui::PushID(function.name.c_str());
        draw_function(frame, function);
        for (const ToldCase& test : function.cases) {
            ImGui::PushID(test.name.c_str());
            draw_case(frame, test);
            const bool is_chosen = test.name == frame.state.mine.test;
            if (scrolls && is_chosen && !ImGui::IsItemVisible()) ImGui::SetScrollHereY();
            ImGui::PopID();
        }
        ImGui::PopID();
    }
    ImGui::EndChild();
}

void draw_back_button(const Frame& frame) {
    const std::string label = fmt::format("Back to {} (g)", frame.state.looked_at->before.stem().string());
    if (ImGui::Button(label.c_str())) look_back(frame.state);
}

void draw_details(const Frame& frame, const ToldTests& tests, const ToldCase& test) {
    const auto [sign, color] = sign_of(frame, test.state);
    const bool is_told = !test.rows.empty() && test.rows[0].name == "test";  // with the scalar in which it failed
    draw_wrapped(color, fmt::format("{} {}", sign, is_told ? test.rows[0].value : test.name));
    if (test.state == learn::State::waiting)
        return faint(frame, fmt::format("It waits for `{}` to be written.", test.waits_for));
    if (test.state != learn::State::failing) return faint(frame, "It passes.");
    draw_rows(frame, "failure", std::span(test.rows).subspan(is_told ? 1 : 0));
    const bool is_pinned = frame.state.looked_at && frame.state.looked_at->test == test.name;
    if (is_pinned) faint(frame, "Its ray is pinned, in the picture, in space and on the other pages.");
    else if (!test.ray) faint(frame, "It traces no ray that a scene could show.");
    else if (ImGui::Button("Look at its ray")) return look_at(frame.state, test);
    if (test.name == tests.first) draw_paragraphs(frame, tests.about_first);
}

/// The line that does not compile; its marked column is in sight.
void draw_source(const Frame& frame, const learn::CompileError& error) {
    if (error.source.empty()) return;
    ImGui::PushFont(frame.fonts.mono);
    ImGui::BeginChild("source line", {0, 3 * ImGui::GetTextLineHeightWithSpacing()}, false,
                      ImGuiWindowFlags_HorizontalScrollbar);
    const std::string lines = learn::with_caret(error);
    ImGui::TextUnformatted(lines.c_str());
    const float column = static_cast<float>(error.place.column) * ImGui::CalcTextSize(" ").x;
    if (is_newly_shown(fmt::format("{} {}", ImGui::GetFontSize(), lines)))
        ImGui::SetScrollX(std::max(0.f, column - .7f * ImGui::GetWindowWidth()));
    ImGui::EndChild();
    ImGui::PopFont();
}

void draw_tests(const Frame& frame, const ToldTests& tests) {
    const auto [sign, color] = sign_of(frame, tests);
    ImGui::PushTextWrapPos(0);  // breaks a path, too, if it is longer than a line
    text_in(color, fmt::format("{} {}", sign, tests.words));
    ImGui::PopTextWrapPos();
    if (tests.error) draw_source(frame, *tests.error);
    draw_paragraphs(frame, tests.rows);
    if (tests.functions.empty()) return;
    const float room = ImGui::GetContentRegionAvail().y, line = ImGui::GetTextLineHeightWithSpacing();
    const ToldCase* const chosen = find_case(tests, frame.state.mine.test);
    const ToldCase* const test = chosen ? chosen : find_case(tests, tests.first);
    draw_list(frame, tests, test ? std::max(6 * line, .5f * room) : std::max(6 * line, room));
    if (!test) return;
    ImGui::BeginChild("details");
    draw_details(frame, tests, *test);
    ImGui::EndChild();
}

void draw_all(const Frame& frame) {
    draw_mine_state(frame);
    faint(frame, "Tests are run for one lesson at a time: choose it above.");
}

}  // namespace

void draw_mine(const Frame& frame) {
    ViewerState& state = frame.state;
    if (!shows_mine(state)) {
        draw_wrapped("Your own functions of a lesson draw a picture beside ours, and are tested at each save.");
        if (ImGui::Button("Show mine (m)")) toggle_mine(state);
        return;
    }
    state.mine.is_tested = true;
    draw_lesson_choice(frame);
    if (state.looked_at) draw_back_button(frame);
    if (!state.mine.problem.empty()) draw_wrapped(frame.palette.warning, "⚠ " + state.mine.problem);
    else if (is_of_all(state.mine)) draw_all(frame);
    else if (frame.results.tests) draw_tests(frame, *frame.results.tests);
}

std::vector<ToldRow> looked_at_rows(const Frame& frame) {
    const LookedAt& looked_at = *frame.state.looked_at;
    const ToldCase* const now = frame.results.tests ? find_case(*frame.results.tests, looked_at.test) : nullptr;
    if (now && now->state == learn::State::passed) return {{"now", "✓ it passes"}};
    return expected_and_got(now && now->state == learn::State::failing ? now->rows : looked_at.rows);
}

void draw_looked_at(const Frame& frame) {
    if (!frame.state.looked_at) return;
    draw_wrapped(frame.palette.accent, "The ray of your test: " + frame.state.looked_at->test);
    draw_rows(frame, "looked at", looked_at_rows(frame));
    ImGui::Separator();
}

void draw_looked_at_banner(const Frame& frame, ImVec2 corner, ImVec2 size) {
    if (!frame.state.looked_at) return;
    const float font = ImGui::GetFontSize(), pad = font / 2, room = size.x - 3 * pad;
    // The picture must stay in sight: where there is little room, each is cut to a line.
    const auto told = [&](bool cut) {
        const auto fitted = [&](const std::string& text) { return cut ? fitting(text, room) : wrapped(text, room); };
        std::string text = fitted("The ray of your test: " + frame.state.looked_at->test);
        for (const auto& [name, value] : looked_at_rows(frame))
            text += '\n' + fitted(fmt::format("{}  {}", name, value));
        return text;
    };
    std::string lines = told(false);
    if (ImGui::CalcTextSize(lines.c_str()).y > .4f * size.y) lines = told(true);
    const ImVec2 extent = ImGui::CalcTextSize(lines.c_str()), from{corner.x + pad / 2, corner.y + 3.3f * font};
    const ImVec2 to{from.x + extent.x + 2 * pad, from.y + extent.y + pad};
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled(from, to, ImGui::GetColorU32(ImGuiCol_PopupBg), pad / 2);
    list.AddRect(from, to, frame.palette.accent, pad / 2);
    list.AddText({from.x + pad, from.y + pad / 2}, frame.palette.text, lines.c_str());
}

}  // namespace glassbox
