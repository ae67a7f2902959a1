#pragma once
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "oracle/oracle.hpp"

/// Random scenes: a picture of some surfaces, and additional rays.
namespace glassbox::fuzz {

struct Drawn {
    std::string kind;
    oracle::Surfaces surfaces;
    oracle::View view;
    int width = 1, height = 1;
    std::vector<oracle::Ray> rays;
};

/// Returns the scene of a seed: always the same one, in programs of one compiler (another one may draw the numbers of
/// an expression in another order). If `kind` is given, only of that kind.
Drawn draw(std::uint64_t seed, std::string_view kind = {});

/// Returns scenes that once revealed faults, to be tested first.
std::vector<Drawn> known();

/// Returns the kinds of scenes.
std::vector<std::string_view> kinds();

/// Returns the picture as a scene file. Surface n has colour n + 1, read as a number of three bytes.
std::string to_toml(const Drawn& drawn);

/// Returns the rays as a table that `glassbox shoot` reads.
std::string to_csv(const std::vector<oracle::Ray>& rays);

}  // namespace glassbox::fuzz
