#pragma once
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "explain/story.hpp"

namespace glassbox {

/// A coordinate of a pixel's ray, or of a surface, that is moved by so many numbers of the scalar that the steps are
/// in: 1 is to the next larger one, −1 to the next smaller one.
struct Nudge {
    std::string input;  ///< "P.x" … "D.z"; of a sphere "centre.x" … "radius"; of a triangle "A.x" … "C.z"
    int by = 0;

    bool operator==(const Nudge&) const = default;
};

/// The farthest that a coordinate is moved. It stays finite, and a radius positive.
inline constexpr int farthest_nudge = 100'000;

/// A number that a test takes, before and after all nudges.
struct NudgedInput {
    std::string name;
    double before = 0, after = 0;
    int by = 0;
};

/// A condition of a test: the number that it looks at, what it says, and whether that is true.
struct Answer {
    Checked number;
    bool holds = false;
    std::optional<bool> truly;  ///< none where it is not known
};

/// A condition before and after. None where the test did not come to it.
struct NudgedAnswer {
    std::string condition;  ///< "Δ ≥ 0"
    std::optional<Answer> before, after;

    bool flips() const { return before && after && before->holds != after->holds; }
};

/// Whether the ray meets the surface, by the chosen scalar and rule, and by that rule without any rounding.
struct NudgedVerdict {
    bool met = false, truly = false;

    bool operator==(const NudgedVerdict&) const = default;
};

/// A surface's test, before and after.
struct Nudged {
    std::vector<NudgedInput> inputs;
    std::vector<NudgedAnswer> answers;  ///< each condition once, in reading order
    NudgedVerdict before, after;
};

/// Tests a listed surface, `story.surfaces[row]`, once as it is and once with all these nudges, by the core's own
/// formulas. A nudge of an input that the surface does not have is none.
Nudged nudged(const Story& story, std::size_t row, std::span<const Nudge> nudges);

/// The verdict in words: "met"; "met, and truly missed".
std::string in_words(const NudgedVerdict& verdict);

}  // namespace glassbox
