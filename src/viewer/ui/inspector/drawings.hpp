#pragma once
#include "explain/story.hpp"
#include "viewer/ui/inspector/canvas.hpp"

namespace glassbox {

// The inspector's drawings, each as wide as given. They lay out what the story says, and compute no number that is
// shown.

/// A number's position on a line with 0, its bound and its true value; below it words on the bound.
void draw_error_bar(const Frame& frame, const story::Number& number, float width);

/// The line through a sphere, in the plane of the line and the centre, with the roots of both rules.
void draw_sphere(const Frame& frame, const Ray<double>& ray, const story::Surface& surface, float width, ImU32 color);

/// A triangle as seen along the ray, which appears as a point; each edge with the sign of its side product.
void draw_triangle(const Frame& frame, const Ray<double>& ray, const story::Surface& surface, float width, ImU32 color);

/// The weights as parts of a whole.
void draw_weights(const Frame& frame, const story::TriangleTest& test, float width);

/// n·l, n·r and n·h, each as the angle between two arrows.
void draw_angles(const Frame& frame, const story::Shade& shade, float width);

/// ambient + diffuse + specular = the pixel, as on paper, one below the other.
void draw_terms(const Frame& frame, const Story& story, const story::Shade& shade, float width);

/// The bits of the number that lost the most: kept, lost before, lost here.
void draw_bits(const Frame& frame, const Options& options, const story::FirstHit& hit, float width);

}  // namespace glassbox
