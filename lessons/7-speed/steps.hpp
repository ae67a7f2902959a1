#pragma once
#include <functional>
#include <string>
#include <vector>

namespace glassbox {

/// The paper's picture, (k_a, k_d, k_s) = (.2, 1, .2), drawn in one of several ways: red, green and blue of each pixel,
/// the top row first.
struct Step {
    std::string name;
    std::function<std::vector<unsigned char>(int width, int height)> draw;
};

/// From the paper's program to the walk through a tree, one change at a time, on one thread. Each draws the same
/// picture. The first two are one source, compiled without optimisation and with.
std::vector<Step> steps_of_speed();

}  // namespace glassbox
