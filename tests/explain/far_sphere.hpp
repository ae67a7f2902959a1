#pragma once
#include "explain/explain.hpp"
#include "scene/scene_file.hpp"

/// The story of the paper's picture in that column and row 350, with one sphere in place of all: of radius 50, ten
/// millions away, in float by the textbook. In float, 24 bits, (v·D)² = v² = 10¹⁴ is rounded, both alike, to a multiple
/// of 2²³, compared with which r² = 2500 is nothing; so Δ = 0 instead of 2500, and all 24 bits are lost in that one
/// difference.
inline glassbox::Story story_of_far_sphere(int column) {
    using namespace glassbox;
    Scene scene = read_scene(SCENES "/levental-2014.toml");
    scene.triangles.clear();
    scene.spheres = {{{-9999500, 350, 350}, 50, {0, 255, 0}}};
    Options options;
    options.scalar = Scalar::float_;
    options.sphere_rule = Textbook{};
    return explain(scene, options, column, 149);
}
