#pragma once
#include "explain/story.hpp"
#include "scene/scene.hpp"

namespace glassbox {

inline bool is_on_border(const Scene& scene, int x, int y) {
    return scene.border && (x == 0 || y == 0 || x == scene.width - 1 || y == scene.height - 1);
}

/// A story of which only is known whose it is: the pixel, its ray, and how it is traced.
inline Story story_of_pixel(const Scene& scene, const Options& options, const Ray<double>& ray, int x, int y) {
    Story story;
    story.title = scene.title;
    story.width = scene.width;
    story.height = scene.height;
    story.x = story.column = x;
    story.y = y;
    story.row = scene.height - 1 - y;
    story.options = options;
    story.ray = ray;
    return story;
}

}  // namespace glassbox
