#pragma once
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "oracle/oracle.hpp"

/// Scenes drawn at random as faults were found: a picture of some surfaces, and rays of one's own.
namespace glassbox::fuzz {

struct Drawn {
    std::string kind;
    oracle::Surfaces surfaces;
    oracle::View view;
    int width = 1, height = 1;
    std::vector<oracle::Ray> rays;
};

/// The scene of a seed: the same one whenever it is asked for, by programs of one compiler (another one may draw the
/// numbers of an expression in another order). Of that kind only, if it is named.
Drawn draw(std::uint64_t seed, std::string_view kind = {});

/// Scenes in which there were faults, to be asked about first.
std::vector<Drawn> known();

/// What kinds there are.
std::vector<std::string_view> kinds();

/// The picture as a scene file. Surface n has colour n + 1, read as a number of three bytes.
std::string to_toml(const Drawn& drawn);

/// The rays as a table that `glassbox shoot` reads.
std::string to_csv(const std::vector<oracle::Ray>& rays);

}  // namespace glassbox::fuzz
