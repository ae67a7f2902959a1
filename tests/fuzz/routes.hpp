#pragma once
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "trial.hpp"

namespace glassbox::fuzz {

/// Something that is wrong.
struct Fault {
    std::string kind;  ///< "wrong surface"
    std::optional<std::size_t> pixel, ray;
    std::string expected, got;
};

/// One way to run the program on a scene.
struct Route {
    std::string name;
    /// Returns the first fault, if there is one.
    std::function<std::optional<Fault>(const Trial&)> check;
    std::string command;  ///< what the same is called on the command line, without the scene
};

/// Returns everything that can be tested: pictures by tiles with each kind of vectors, ray by ray and in the plain
/// loop; measurements; shots by all rules; the view's rays.
std::vector<Route> all_routes();

}  // namespace glassbox::fuzz
