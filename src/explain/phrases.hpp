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

/// "± 3.1e-10"; "exact"; "± unknown".
std::string bound(double error);

/// "1.6 bits lost"; "no bits lost".
std::string lost(double bits);

/// Of the truth: "> 0", "< 0", "= 0", "unknown".
std::string_view sign(const story::Number& number);

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
