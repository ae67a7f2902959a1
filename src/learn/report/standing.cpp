#include "learn/report/standing.hpp"

#include <algorithm>

namespace glassbox::learn {

int functions_passed(const LessonStanding& lesson) {
    return static_cast<int>(
        std::ranges::count(lesson.functions, State::passed, [](const auto& function) { return function.state; }));
}

std::optional<int> pixels_differing(const LessonStanding& lesson) {
    const auto& [mine, ours] = std::tie(lesson.mine, lesson.ours);
    if (!mine || !ours || mine->width != ours->width || mine->height != ours->height) return std::nullopt;
    int differing = 0;
    for (std::size_t k = 0; k < mine->pixels.size(); ++k) differing += mine->pixels[k] != ours->pixels[k];
    return differing;
}

}  // namespace glassbox::learn
