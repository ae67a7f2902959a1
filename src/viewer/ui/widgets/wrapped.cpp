#include "viewer/ui/widgets/wrapped.hpp"

#include <algorithm>

namespace glassbox {

namespace {

float width_of(std::string_view text) { return ImGui::CalcTextSize(text.data(), text.data() + text.size()).x; }

/// Wraps one line, at spaces only.
std::string wrapped_line(std::string_view line, float room) {
    std::string result(line);
    std::size_t begin = 0, last_space = std::string::npos;  // of the current part; where it could end
    for (std::size_t i = 0; i <= result.size(); ++i) {
        if (i < result.size() && result[i] != ' ') continue;
        const bool too_wide = width_of(std::string_view(result).substr(begin, i - begin)) > room;
        if (too_wide && last_space != std::string::npos) {
            result[last_space] = '\n';
            begin = last_space + 1;
        }
        last_space = i;
    }
    return result;
}

}  // namespace

std::string wrapped(std::string_view text) { return wrapped(text, ImGui::GetContentRegionAvail().x); }

std::string wrapped(std::string_view text, float room) {
    std::string result;
    while (true) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        result += wrapped_line(text.substr(0, end), room);
        if (end == text.size()) return result;
        result += '\n';
        text.remove_prefix(end + 1);
    }
}

std::string fitting(const std::string& text, float width) {
    if (ImGui::CalcTextSize(text.c_str()).x <= width) return text;
    const char* rest = nullptr;
    const float dots = ImGui::CalcTextSize("…").x;
    ImGui::GetFont()->CalcTextSizeA(ImGui::GetFontSize(), std::max(width - dots, 1.f), 0, text.c_str(), nullptr, &rest);
    return std::string(text.c_str(), rest) + "…";
}

void draw_wrapped(std::string_view text) {
    const std::string lines = wrapped(text);
    ImGui::TextUnformatted(lines.c_str(), lines.c_str() + lines.size());
}

void draw_wrapped(ImU32 color, std::string_view text) {
    ImGui::PushStyleColor(ImGuiCol_Text, color);
    draw_wrapped(text);
    ImGui::PopStyleColor();
}

}  // namespace glassbox
