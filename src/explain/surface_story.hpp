#pragma once
#include <cstddef>
#include <optional>
#include <span>
#include <variant>
#include <vector>

#include "engine/engine.hpp"
#include "explain/story.hpp"
#include "explain/told_test.hpp"
#include "explain/traced_pixel.hpp"

namespace glassbox {

/// The numbers of the surfaces worth telling: those met, and `besides`; then those that the ray misses by the least, at
/// most `most` in all; in the order of their numbers.
std::vector<std::size_t> worth_telling(const engine::Engine& surfaces, const TracedPixel& pixel,
                                       std::span<const std::size_t> besides, std::size_t most);

/// Why a surface was missed: `test` has the chosen rule's numbers, `t` is where the line meets it, if that was
/// computed.
story::Fate why_missed(const std::variant<story::SphereTest, story::TriangleTest>& test,
                       const std::optional<story::Number>& t, const Options& options);

/// The story of one surface; `known` is its test by the chosen rule, where it was recorded already. The caller fills in
/// its kind and colour.
story::Surface surface_story(const engine::Engine& surfaces, const Options& options, const TracedPixel& pixel,
                             std::size_t number, std::optional<ToldTest> known);

}  // namespace glassbox
