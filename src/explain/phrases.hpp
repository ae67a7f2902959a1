#pragma once
#include <cstddef>
#include <span>
#include <string>
#include <string_view>

#include "explain/story.hpp"

namespace glassbox {

// The phrases that every way of showing a story has in common.

/// Six digits.
std::string short_number(double value);

/// "(0.5, 1, -2)".
std::string triple(const Vec3<double>& v);
std::string triple(const story::Vector& v);
std::string triple(Rgb color);

/// As C writes hexadecimal floats. A long double that a double can hold is written as one: 0x1.8p+0 and not 0xc.p-3.
std::string hex(double value);
std::string hex(long double value);

/// A number and its bound as they are printed side by side. The prints themselves keep |value − truth| ≤ bound.
struct WithBound {
    std::string value, bound;
};

/// With the digits that the bound deserves: "0.28388916" and "± 2.7e-07"; "350" and "exact"; "350" and "± unknown".
WithBound with_bound(const story::Number& number);

/// The bound beside a value that was printed in another way, rounded up to so many digits: "± 3.1e-10"; "exact", "exact
/// as a double" where only the double is, and not the decimal; "± unknown".
std::string bound(std::string_view printed, const story::Number& number, int digits = 2);

/// The truth, rounded once, with all its digits: "0.1"; "unknown"; "0, as far as 320 bits tell".
std::string truth(const story::Number& number);

/// "1.6 bits lost"; "no bits lost"; where that is not known: "truly unknown", "truly 0, as far as 320 bits tell".
std::string lost(const story::Number& number);

/// The same, with the sign of the truth before it: "truly > 0, 1.6 bits lost".
std::string sign_and_lost(const story::Number& number);

/// Why a surface was met, or not: "missed: side products of both signs, the line passes outside".
std::string why(const story::Surface& surface, const Story& story);

/// What the pixel shows: "sphere of colour (0, 255, 0), surface 0, at t = 441.716".
std::string verdict_phrase(const Story& story);

/// How the difference stands to the tolerance: "under 10"; "not under 10"; "but a+b+c is 0".
std::string tolerance_phrase(const story::TriangleTest& test);

/// A step with the values of its operands: "500 − 441.716".
std::string operation(std::span<const story::StoryStep> steps, const Step& step);

/// Where a step was asked for: "at core/1-rays/vec3.hpp:12".
std::string place(const Step& step);

/// How many of the steps are operations, and not what they start from.
std::size_t count_operations(const story::FirstHit& hit);

}  // namespace glassbox
