#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <string_view>

#include "viewer/model/story/lesson.hpp"
#include "viewer/ui/steps/parts.hpp"
#include "viewer/ui/widgets/wrapped.hpp"

namespace glassbox {

namespace {

/// Draws code in the text's colour, and what follows // in a faint one.
void draw_code(const Frame& frame, ImVec2 at, std::string_view line) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const std::size_t comment = std::min(line.find("//"), line.size());
    const char* const begin = line.data();
    list.AddText(at, frame.palette.text, begin, begin + comment);
    at.x += ImGui::CalcTextSize(begin, begin + comment).x;
    list.AddText(at, frame.palette.faint_text, begin + comment, begin + line.size());
}

void draw_lines(const Frame& frame, const std::vector<std::string_view>& text, std::size_t marked) {
    const float em = ImGui::GetFontSize(), height = ImGui::GetTextLineHeightWithSpacing();
    const float gutter = ImGui::CalcTextSize("9999 ").x;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    ImGuiListClipper clipper;
    clipper.Begin(static_cast<int>(text.size()), height);
    while (clipper.Step())
        for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i) {
            const auto index = static_cast<std::size_t>(i);
            const std::string_view line = text[index];
            const ImVec2 at = ImGui::GetCursorScreenPos();
            const float width = gutter + ImGui::CalcTextSize(line.data(), line.data() + line.size()).x + em;
            if (index + 1 == marked) {
                const float left = ImGui::GetWindowPos().x, right = left + ImGui::GetWindowWidth();
                list.AddRectFilled({left, at.y}, {right, at.y + height}, ImGui::GetColorU32(ImGuiCol_Header));
                list.AddRectFilled({left, at.y}, {left + em / 4, at.y + height}, frame.palette.accent);
            }
            list.AddText(at, index + 1 == marked ? frame.palette.accent : frame.palette.line,
                         fmt::format("{:>4}", index + 1).c_str());
            draw_code(frame, {at.x + gutter, at.y}, line);
            ImGui::Dummy({width, ImGui::GetTextLineHeight()});
        }
}

/// Scrolls a line to the middle when the line or the file has changed.
void follow(const SourceFile& file, std::size_t line) {
    ImGuiStorage* const storage = ImGui::GetStateStorage();
    const ImGuiID id = ImGui::GetID("line");
    const auto key = static_cast<int>(&file - core_sources().data()) * 10000 + static_cast<int>(line);
    const bool is_new = storage->GetInt(id, -1) != key;
    storage->SetInt(id, key);
    if (!is_new) return;
    const float middle = (static_cast<float>(line) - .5f) * ImGui::GetTextLineHeightWithSpacing();
    ImGui::SetScrollY(std::max(0.f, middle - ImGui::GetWindowHeight() / 2));
    ImGui::SetScrollX(0);
}

}  // namespace

float lesson_height(const Frame& frame, const Event& event) {
    const Described lesson = lesson_of(*frame.results.story, event);
    if (lesson.text.empty()) return 0;
    const float text = ImGui::CalcTextSize(lesson.text.c_str(), nullptr, false, ImGui::GetContentRegionAvail().x).y;
    return text + ImGui::GetTextLineHeightWithSpacing() + 3 * ImGui::GetStyle().ItemSpacing.y;
}

void draw_lesson(const Frame& frame, const Event& event, float height) {
    const Described lesson = lesson_of(*frame.results.story, event);
    if (lesson.text.empty()) return;
    ImGui::BeginChild("lesson", {0, std::max(1.f, height - ImGui::GetStyle().ItemSpacing.y)});
    ImGui::PushStyleColor(ImGuiCol_Text, frame.palette.accent);
    ImGui::TextWrapped("%s, as %s says:", lesson.name.c_str(), std::string(lesson.file->path).c_str());
    ImGui::PopStyleColor();
    draw_wrapped(lesson.text);
    ImGui::EndChild();
}

void draw_source(const Frame& frame, const Event& event, float height) {
    const SourceLine source = source_of(*frame.results.story, event);
    if (!source.file) return;
    const std::string place =
        source.line > 0 ? fmt::format("{}:{}", source.file->path, source.line) : std::string(source.file->path);
    const float top = ImGui::GetCursorPosY();
    ImGui::Separator();
    ImGui::TextDisabled("%s", fitting(place, ImGui::GetContentRegionAvail().x).c_str());
    height -= ImGui::GetCursorPosY() - top + ImGui::GetStyle().ItemSpacing.y;
    ImGui::BeginChild("source", {0, height}, true, ImGuiWindowFlags_HorizontalScrollbar);
    ImGui::PushFont(frame.fonts.mono);
    const std::size_t line = source.line > 0 ? source.line : lesson_of(*frame.results.story, event).line;
    follow(*source.file, line);
    draw_lines(frame, lines(*source.file), source.line);
    ImGui::PopFont();
    ImGui::EndChild();
}

}  // namespace glassbox
