#pragma once
#include <span>
#include <string>

#include "render/setup.hpp"

namespace glassbox {

// How the viewer changes a setup.

/// One of the paper's five figures: which terms it has, as (k_a, k_d, k_s).
struct Figure {
    const char* name;
    double k_a, k_d, k_s;
};
inline constexpr Figure figures[] = {
    {"Ambient", 1, 0, 0}, {"Diffuse", 0, 1, 0}, {"Specular", 0, 0, 1}, {"Specular + diffuse", 0, 1, .2},
    {"Final", .2, 1, .2},
};

/// The same setup, shaded as the paper's program shaded that figure: its model, exponent 15, its colours, intensity 1,
/// its sphere rule, and at least the stage that knows shading.
Setup with_figure(Setup setup, const Figure& figure);

/// The same setup, turned further.
Setup turned(Setup setup, Axis axis, double degrees);

/// The angle of the last turn, in degrees; 0 if that is about another axis, or there is none.
double last_turn(const Setup& setup, Axis axis);

/// Turns by this angle instead of the last one's, if that is about this axis; otherwise once more. By 0 degrees: not.
Setup with_last_turn(Setup setup, Axis axis, double degrees);

/// The turns in words, equal neighbours counted: "z 10° × 36, y −20°"; "none".
std::string turns_in_words(std::span<const Turn<double>> turns);

/// A setup for a scene whose file has changed: what was as the file said follows it, what the user changed stays.
Setup followed(Setup setup, const Scene& before, const Scene& after);

/// Where a vector points: the azimuth counts from x counter-clockwise about z, the elevation from the xy plane towards
/// z, both in degrees.
struct Pointing {
    double azimuth = 0, elevation = 0, distance = 1;
};
Pointing pointing(const Vec3<double>& v);
Vec3<double> vector_of(const Pointing& pointing);

}  // namespace glassbox
