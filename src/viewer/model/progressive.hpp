#pragma once
#include <algorithm>
#include <chrono>

#include "render/view.hpp"
#include "scene/scene.hpp"

namespace glassbox {

/// Calls `make(scene, factor)` with the scene as an ever larger picture, 1/factor of its width and height, until it has
/// all its pixels: the first is there at once, whatever the whole one takes. Sizes that would take no time are skipped.
template <class Make>
void coarse_to_fine(const Scene& scene, const Make& make) {
    using Seconds = std::chrono::duration<double>;
    constexpr double at_once = 0.03;  // seconds
    constexpr int coarsest = 16, least_side = 8;
    int factor = coarsest;
    while (factor > 1 && std::min(scene.width, scene.height) / factor < least_side) factor /= 2;
    while (factor > 1) {
        const auto start = std::chrono::steady_clock::now();
        make(resized(scene, scene.width / factor, scene.height / factor), factor);
        double next = 4 * Seconds(std::chrono::steady_clock::now() - start).count();
        factor /= 2;
        for (; factor > 1 && 4 * next < at_once; factor /= 2) next *= 4;
    }
    make(scene, 1);
}

}  // namespace glassbox
