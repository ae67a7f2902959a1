#pragma once
#include <string>
#include <vector>

namespace glassbox {

/// Something that every bound takes for granted of the machine, the build and the process.
struct Assumption {
    std::string what;
    std::string not_in;  ///< the scalars for which it does not hold: "float, double"; empty if all is well
    std::string remedy;
};

/// Tries all of them, in the thread that calls it. They hold for IEEE 754's arithmetic as it is by default, compiled as
/// our CMakeLists.txt says.
std::vector<Assumption> try_assumptions();

}  // namespace glassbox
