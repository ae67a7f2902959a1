#pragma once
#include <cstddef>
#include <span>
#include <string>
#include <string_view>

#include "explain/story.hpp"

namespace glassbox {

// Phrases shared by all ways of showing a story.

/// The number as texts for people have it, with − before it in place of the hyphen of programs and files.
std::string with_minus(std::string number);

/// The number with six digits.
std::string short_number(double value);

/// "(0.5, 1, -2)".
std::string triple(const Vec3<double>& v);
std::string triple(const story::Vector& v);
std::string triple(Rgb color);

/// The number in C's hexadecimal format. A long double that a double can hold is written as one: 0x1.8p+0, not 0xc.p-3.
std::string hex(double value);
std::string hex(long double value);

/// A number and its bound, printed side by side. The printed numbers themselves satisfy |value − truth| ≤ bound.
struct WithBound {
    std::string value, bound;
};

/// With the digits that the bound justifies: "0.28388916" and "± 2.7e-07"; "350" and "exact"; "350" and "± unknown".
WithBound with_bound(const story::Number& number);

/// The bound beside a value printed as `printed`, rounded up to that many digits: "± 3.1e-10"; "exact"; "exact as a
/// double" where only the double is exact, not the decimal; "± unknown".
std::string bound(std::string_view printed, const story::Number& number, int digits = 2);

/// The true value, rounded once, with all its digits: "0.1"; "unknown"; "0, as far as 320 bits tell".
std::string truth(const story::Number& number);

/// "1.6 bits lost"; "no bits lost"; where that is not known: "truly unknown", "truly 0, as far as 320 bits tell".
std::string lost(const story::Number& number);

/// The same after the sign of the true value: "truly > 0, 1.6 bits lost"; "wrong: truly > 0, 24.0 bits lost" where the
/// computed one is another.
std::string sign_and_lost(const story::Number& number);

/// An operation's two losses: "9.0 bits of its own, none inherited"; "its own loss is not known".
std::string own_and_inherited(const story::Number& number);

/// Why a surface was met, or not: "missed: side products of both signs, the line passes outside".
std::string why(const story::Surface& surface, const Story& story);

/// What the pixel shows: "sphere of colour (0, 255, 0), surface 0, at t = 441.716".
std::string shown_phrase(const Story& story);

/// The angle that belongs to a dot product of unit vectors, in degrees; rounding may have carried it beyond ±1.
double angle(double cosine);

/// The same in words: "37.8°"; "no angle" for what is no number.
std::string degrees(double cosine);

/// How the difference compares with the tolerance: "under 10"; "not under 10"; "but a+b+c is 0".
std::string tolerance_phrase(const story::TriangleTest& test);

/// A step with the values of its operands, "500 − 441.716": with six digits, or as many more as show that two which
/// cancel, or are compared, differ: "254160179.3 − 254160178.9".
std::string operation(std::span<const story::StoryStep> steps, const Step& step);

/// A step's place in the source: "at core/1-rays/vec3.hpp:12".
std::string place(const Step& step);

/// How many of the steps are operations, not inputs or constants.
std::size_t count_operations(const story::FirstHit& hit);

}  // namespace glassbox
