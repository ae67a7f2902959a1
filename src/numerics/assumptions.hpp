#pragma once
#include <string>
#include <vector>

namespace glassbox {

/// An assumption about the machine, the build and the process that every error bound relies on.
struct Assumption {
    std::string what;
    std::string not_in;  ///< the scalars for which it does not hold: "float, double"; empty if it holds for all
    std::string remedy;
};

/// Checks all assumptions in the calling thread. They hold for IEEE 754's arithmetic in its default mode, compiled as
/// our CMakeLists.txt says.
std::vector<Assumption> try_assumptions();

}  // namespace glassbox
