#include "viewer/ui/space/labels.hpp"

#include <algorithm>

namespace glassbox {

void Labels::put(ImVec2 point, float gap, const std::string& words, ImU32 color) {
    const ImVec2 size = ImGui::CalcTextSize(words.c_str());
    // Right above, right below, left above, …: how much of the size lies left of and above the point.
    constexpr struct {
        float left, above, x, y;
    } places[] = {{0, 1, 1, -.5f},   {0, 0, 1, .5f},     {1, 1, -1, -.5f},   {1, 0, -1, .5f},
                  {0, .5f, 1.5f, 0}, {1, .5f, -1.5f, 0}, {.5f, 1, 0, -1.5f}, {.5f, 0, 0, 1.5f}};
    for (const float farther : {1.f, 3.f})
        for (const auto& [left, above, x, y] : places) {
            const ImVec2 at{point.x - left * size.x + x * gap * farther, point.y - above * size.y + y * gap * farther};
            const ImVec4 place{at.x - 2, at.y, at.x + size.x + 2, at.y + size.y};
            if (!is_free(place)) continue;
            taken_.push_back(place);
            list_.AddRectFilled({place.x, place.y}, {place.z, place.w}, ground_, size.y / 5);
            list_.AddText(at, color, words.c_str());
            return;
        }
}

bool Labels::is_free(const ImVec4& place) const {
    if (place.x < least_.x || place.y < least_.y || place.z > greatest_.x || place.w > greatest_.y) return false;
    return std::none_of(taken_.begin(), taken_.end(), [&](const ImVec4& other) {
        return place.x < other.z && other.x < place.z && place.y < other.w && other.y < place.w;
    });
}

}  // namespace glassbox
