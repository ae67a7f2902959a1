#include "viewer/ui/space/labels.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace glassbox {

namespace {

constexpr float margin = 2;  // of words, on their left and right

/// Whether a line crosses a rectangle: cut to the rectangle, something of it is left.
bool crosses(const ImVec4& line, const ImVec4& place) {
    float from = 0, to = 1;
    const auto cut = [&](float start, float by, float least, float greatest) {
        if (by == 0) return start >= least && start <= greatest;
        const auto [enters, leaves] = std::minmax({(least - start) / by, (greatest - start) / by});
        from = std::max(from, enters);
        to = std::min(to, leaves);
        return from <= to;
    };
    return cut(line.x, line.z - line.x, place.x, place.z) && cut(line.y, line.w - line.y, place.y, place.w);
}

}  // namespace

void Labels::put(ImVec2 point, float gap, const std::string& words, ImU32 color) {
    const ImVec2 size = ImGui::CalcTextSize(words.c_str());
    // Right above, right below, left above, …: how much of the size lies left of and above the point.
    constexpr struct {
        float left, above, x, y;
    } places[] = {{0, 1, 1, -.5f},   {0, 0, 1, .5f},     {1, 1, -1, -.5f},   {1, 0, -1, .5f},
                  {0, .5f, 1.5f, 0}, {1, .5f, -1.5f, 0}, {.5f, 1, 0, -1.5f}, {.5f, 0, 0, 1.5f}};
    const auto try_all = [&](float away, bool off_lines, bool joined) {
        return std::any_of(std::begin(places), std::end(places), [&](const auto& p) {
            const ImVec2 at{point.x - p.left * size.x + p.x * away, point.y - p.above * size.y + p.y * away};
            const ImVec4 place{at.x - margin, at.y, at.x + size.x + margin, at.y + size.y};
            return (!off_lines || is_off_lines(place)) && put_at(place, point, joined, words, color);
        });
    };
    for (const float away : {gap, 3 * gap})
        if (try_all(away, true, false)) return;
    for (const float away : {1.f, 1.7f, 2.5f})
        if (try_all(3 * gap + away * size.y, true, true)) return;
    for (const float away : {gap, 3 * gap})
        if (try_all(away, false, false)) return;
}

bool Labels::put_at(const ImVec4& place, ImVec2 point, bool joined, const std::string& words, ImU32 color) {
    if (!is_free(place)) return false;
    taken_.push_back(place);
    if (joined)
        list_.AddLine(point, {std::clamp(point.x, place.x, place.z), std::clamp(point.y, place.y, place.w)}, color);
    list_.AddRectFilled({place.x, place.y}, {place.z, place.w}, ground_, (place.w - place.y) / 5);
    list_.AddText({place.x + margin, place.y}, color, words.c_str());
    return true;
}

bool Labels::is_free(const ImVec4& place) const {
    if (place.x < least_.x || place.y < least_.y || place.z > greatest_.x || place.w > greatest_.y) return false;
    return std::none_of(taken_.begin(), taken_.end(), [&](const ImVec4& other) {
        return place.x < other.z && other.x < place.z && place.y < other.w && other.y < place.w;
    });
}

bool Labels::is_off_lines(const ImVec4& place) const {
    return std::none_of(lines_.begin(), lines_.end(), [&](const ImVec4& line) { return crosses(line, place); });
}

}  // namespace glassbox
