#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <string>
#include <string_view>

#include "viewer/model/story/code.hpp"
#include "viewer/model/story/functions.hpp"
#include "viewer/model/story/lesson.hpp"
#include "viewer/model/story/stepping.hpp"
#include "viewer/model/story/steps_now.hpp"
#include "viewer/ui/steps/parts.hpp"
#include "viewer/ui/widgets/buttons.hpp"
#include "viewer/ui/widgets/wrapped.hpp"

namespace glassbox {

namespace {

ImU32 color_of(const Palette& palette, CodeKind kind) {
    switch (kind) {
        case CodeKind::keyword:
            return palette.keyword;
        case CodeKind::number:
            return palette.number;
        case CodeKind::text:
            return palette.string;
        case CodeKind::comment:
            return palette.comment;
        case CodeKind::plain:
            break;
    }
    return palette.text;
}

float draw_piece(const Frame& frame, ImVec2 at, const CodePiece& piece) {
    const char *const begin = piece.text.data(), *const end = begin + piece.text.size();
    ImGui::GetWindowDrawList()->AddText(at, color_of(frame.palette, piece.kind), begin, end);
    return ImGui::CalcTextSize(begin, end).x;
}

/// Draws all of a source file, its long lines broken; returns how high it is, and where the middle of a line is.
struct Drawn {
    float height = 0, middle = 0;
};
Drawn draw_lines(const Frame& frame, const SourceFile& file, std::size_t marked, std::size_t wanted) {
    const float height = ImGui::GetTextLineHeightWithSpacing(), column = ImGui::CalcTextSize("0").x;
    const float gutter = 5 * column, em = ImGui::GetFontSize();
    const float room = ImGui::GetContentRegionAvail().x - gutter;
    const auto columns = static_cast<std::size_t>(std::max(16.f, room / column));
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const float top = ImGui::GetWindowPos().y, bottom = top + ImGui::GetWindowHeight();
    Drawn drawn;
    const std::vector<std::string_view> text = lines(file);
    for (std::size_t i = 0; i < text.size(); ++i) {
        const std::vector<CodeRow> rows = code_rows(text[i], columns);
        const float y = corner.y + drawn.height, tall = height * static_cast<float>(rows.size());
        if (i + 1 == wanted) drawn.middle = drawn.height + tall / 2;
        drawn.height += tall;
        if (y + tall < top || y > bottom) continue;
        if (i + 1 == marked) {
            const float left = ImGui::GetWindowPos().x, right = left + ImGui::GetWindowWidth();
            list.AddRectFilled({left, y}, {right, y + tall}, ImGui::GetColorU32(ImGuiCol_Header));
            list.AddRectFilled({left, y}, {left + em / 4, y + tall}, frame.palette.accent);
        }
        list.AddText({corner.x, y}, i + 1 == marked ? frame.palette.text : frame.palette.faint_text,
                     fmt::format("{:>4}", i + 1).c_str());
        for (std::size_t row = 0; row < rows.size(); ++row) {
            ImVec2 at{corner.x + gutter + column * static_cast<float>(rows[row].indent),
                      y + height * static_cast<float>(row)};
            for (const CodePiece& piece : rows[row].pieces) at.x += draw_piece(frame, at, piece);
        }
    }
    ImGui::Dummy({1, drawn.height});
    return drawn;
}

/// Scrolls a line to the middle when the line, the file or the width has changed.
void follow_line(const SourceFile& file, std::size_t line, float middle) {
    ImGuiStorage* const storage = ImGui::GetStateStorage();
    const ImGuiID id = ImGui::GetID("line"), width_id = ImGui::GetID("width");
    const auto key = static_cast<int>(std::hash<const void*>{}(&file) * 10000 + line);
    const auto width = static_cast<int>(ImGui::GetWindowWidth());
    if (storage->GetInt(id, -1) == key && storage->GetInt(width_id, -1) == width) return;
    storage->SetInt(id, key);
    storage->SetInt(width_id, width);
    ImGui::SetScrollY(std::max(0.f, middle - ImGui::GetWindowHeight() / 2));
}

/// The text of a line of the stack; where only the function is known, that.
std::string told(const StackLine& line) {
    if (line.line == 0) return fmt::format("{}: with an operator of vectors", line.function);
    return std::string(code_of(line));
}

/// Draws the lines of the stack, each a bit further in; the one at `level` is marked, and brought into sight once.
void draw_stack(const Frame& frame, const std::vector<StackLine>& stack, std::size_t level) {
    const float em = ImGui::GetFontSize(), height = ImGui::GetTextLineHeightWithSpacing();
    ImGuiStorage* const storage = ImGui::GetStateStorage();
    const ImGuiID id = ImGui::GetID("looked at");
    const int key = static_cast<int>(32 * frame.state.step + level);
    const bool is_new = storage->GetInt(id, -1) != key;
    storage->SetInt(id, key);
    ImGui::PushFont(frame.fonts.mono);
    const float column = ImGui::CalcTextSize("0").x;
    const auto columns =
        static_cast<std::size_t>(std::max(16.f, (ImGui::GetContentRegionAvail().x - 1.2f * em) / column));
    for (std::size_t i = 0; i < stack.size(); ++i) {
        const std::string text = std::string(2 * std::min<std::size_t>(i, 3), ' ') + told(stack[i]);
        const std::vector<CodeRow> rows = code_rows(text, columns);
        const float tall = height * static_cast<float>(rows.size());
        ImGui::PushID(static_cast<int>(i));
        const ImVec2 at = ImGui::GetCursorScreenPos();
        if (ImGui::Selectable("##line", i == level, 0, {0, tall - ImGui::GetStyle().ItemSpacing.y}))
            look_at_level(frame.state, i);
        if (ImGui::IsItemHovered())
            ImGui::SetTooltip("%s, %s:%zu", stack[i].function.c_str(), std::string(stack[i].file->path).c_str(),
                              stack[i].line);
        const float below = at.y + tall - ImGui::GetWindowPos().y - ImGui::GetWindowHeight();
        if (i == level && is_new && (below > 0 || at.y < ImGui::GetWindowPos().y)) ImGui::SetScrollHereY(1);
        if (i == level) ImGui::GetWindowDrawList()->AddText(at, frame.palette.text, "▶");
        for (std::size_t row = 0; row < rows.size(); ++row) {
            ImVec2 place{at.x + 1.2f * em + column * static_cast<float>(rows[row].indent),
                         at.y + height * static_cast<float>(row)};
            for (const CodePiece& piece : rows[row].pieces) place.x += draw_piece(frame, place, piece);
        }
        ImGui::PopID();
    }
    ImGui::PopFont();
}

void draw_lesson(const Frame& frame, const Described& lesson) {
    if (lesson.text.empty()) return;
    draw_wrapped(frame.palette.accent, fmt::format("{}, as {} says:", lesson.name, lesson.file->path));
    draw_wrapped(lesson.text);
}

}  // namespace

void draw_source(const Frame& frame, const Event& event) {
    const std::vector<StackLine> stack = call_stack(*steps_now(frame.state, frame.results).story, event);
    const Described lesson = lesson_of(*steps_now(frame.state, frame.results).story, event);
    const std::size_t level = level_now(frame.state, frame.results);
    SourceLine source = source_of(*steps_now(frame.state, frame.results).story, event);
    std::size_t wanted = source.line > 0 ? source.line : lesson.line;
    if (!stack.empty()) {
        source = {stack[level].file, stack[level].line};
        wanted = source.line;
        for (const SourceFunction& function : functions_of(*source.file))
            if (wanted == 0 && function.name == stack[level].function) wanted = function.first;
    }
    const float line = ImGui::GetTextLineHeightWithSpacing(), room = ImGui::GetContentRegionAvail().y;
    const float gap = ImGui::GetStyle().ItemSpacing.y;
    const float lesson_height = room > 20 * line ? .25f * room : 0;  // else it has a pane to itself alone
    ImGui::BeginChild("stack", {0, std::max(3.5f * line, .22f * room)}, true);
    if (stack.empty()) draw_wrapped(frame.palette.faint_text, "No line alone does this.");
    else draw_stack(frame, stack, level);
    ImGui::EndChild();
    if (source.file) {
        const std::string place =
            source.line > 0 ? fmt::format("{}:{}", source.file->path, source.line) : std::string(source.file->path);
        ImGui::TextDisabled("%s", fitting(place, ImGui::GetContentRegionAvail().x).c_str());
    } else ImGui::TextDisabled("%s", "");
    ImGui::BeginChild(
        "source",
        {0, std::max(ImGui::GetContentRegionAvail().y - lesson_height - (lesson_height > 0 ? gap : 0), 4 * line)},
        true);
    ImGui::PushFont(frame.fonts.mono);
    if (source.file) follow_line(*source.file, wanted, draw_lines(frame, *source.file, source.line, wanted).middle);
    ImGui::PopFont();
    ImGui::EndChild();
    if (lesson_height == 0) return;
    ImGui::BeginChild("lesson", {0, lesson_height});
    draw_lesson(frame, lesson);
    ImGui::EndChild();
}

void draw_formula(const Frame& frame, const Event& event) {
    const Described lesson = lesson_of(*steps_now(frame.state, frame.results).story, event);
    ImGui::BeginChild("formula", {0, 0}, true);
    if (lesson.text.empty()) draw_wrapped(frame.palette.faint_text, "The core says nothing about this step.");
    draw_lesson(frame, lesson);
    ImGui::EndChild();
}

}  // namespace glassbox
