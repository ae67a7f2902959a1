#include "scene/ears.hpp"

#include <algorithm>
#include <deque>

namespace glassbox {
namespace {

/// Enough for all ears of five thousand corners; they take half a second.
constexpr std::size_t most_comparisons = 20'000'000;

}  // namespace

std::vector<std::array<std::size_t, 3>> cut_ears(std::span<const Point2> outline) {
    const std::size_t n = outline.size();
    std::vector<std::size_t> before(n), after(n);
    for (std::size_t k = 0; k < n; ++k) before[k] = (k + n - 1) % n, after[k] = (k + 1) % n;

    const auto turn = [&](std::size_t a, std::size_t b, std::size_t c) {
        return orientation(outline[a], outline[b], outline[c]);
    };
    // Only corners that do not turn left can lie in an ear, and cutting ears makes no new ones.
    std::vector<std::size_t> obstacles;
    for (std::size_t k = 0; k < n; ++k)
        if (turn(before[k], k, after[k]) <= 0) obstacles.push_back(k);
    const auto lies_in = [&](std::size_t p, std::size_t a, std::size_t b, std::size_t c) {
        if (outline[p] == outline[a] || outline[p] == outline[b] || outline[p] == outline[c]) return false;
        return turn(a, b, p) >= 0 && turn(b, c, p) >= 0 && turn(c, a, p) >= 0;
    };
    std::size_t comparisons = 0;
    const auto is_ear = [&](std::size_t b) {
        const std::size_t a = before[b], c = after[b];
        return turn(a, b, c) > 0 && std::none_of(obstacles.begin(), obstacles.end(), [&](std::size_t p) {
                   ++comparisons;
                   return lies_in(p, a, b, c);
               });
    };

    std::vector<std::array<std::size_t, 3>> triangles;
    const auto cut = [&](std::size_t b) {
        const std::size_t a = before[b], c = after[b];
        if (turn(a, b, c) != 0) triangles.push_back({a, b, c});
        after[a] = c;
        before[c] = a;
    };
    // A corner is tested again only after a neighbour was cut off: each cut adds two tests, so there are 3n in all.
    std::deque<std::size_t> to_ask;
    std::vector<bool> is_left(n, true);
    for (std::size_t k = 0; k < n; ++k) to_ask.push_back(k);
    std::size_t left = n, start = 0;
    for (; left > 2 && !to_ask.empty() && comparisons < most_comparisons; to_ask.pop_front()) {
        const std::size_t ear = to_ask.front();
        if (!is_left[ear] || !is_ear(ear)) continue;
        cut(ear);
        is_left[ear] = false;
        --left;
        start = after[ear];
        to_ask.insert(to_ask.end(), {before[ear], after[ear]});
    }
    for (; left > 2; --left) cut(after[start]);
    return triangles;
}

}  // namespace glassbox
