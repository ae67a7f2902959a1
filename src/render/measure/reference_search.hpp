#pragma once
#include <memory>

#include "engine/engine.hpp"
#include "render/measure/pixel_numbers.hpp"
#include "render/options.hpp"
#include "render/search/exact_crossing.hpp"

namespace glassbox {

/// What a ray truly meets.
struct TrueHits {
    std::size_t hits = 0;                ///< surfaces that it meets
    std::optional<std::size_t> nearest;  ///< of those at the same distance the one listed last
    std::optional<TrueT> t;              ///< of the nearest
};

/// Finds what rays truly meet, to hold against it what a search found. It shares none of a search's short cuts: each
/// surface is asked, with running bounds and, where they do not tell, exactly; none is passed over for lying behind
/// another, and distances that bounds do not tell apart are compared exactly. Only in scenes of more surfaces than
/// `few` are those left out whose boxes the ray surely misses.
class ReferenceSearch {
public:
    static constexpr std::size_t few = 2000;

    /// Of the surfaces in the engine.
    explicit ReferenceSearch(std::shared_ptr<const engine::Engine> engine) : engine_(std::move(engine)) {}

    /// `ray` must be valid.
    TrueHits true_hits(const Ray<double>& ray) const;

    /// How many surfaces the ray meets.
    double hits(const Ray<double>& ray) const { return is_valid(ray) ? static_cast<double>(true_hits(ray).hits) : 0; }

    /// Fills in the pixel's verdict and, where it found the right surface, the bits that its t has lost. `scalar` is
    /// the one that found it.
    void compare(const Ray<double>& ray, Scalar scalar, PixelNumbers& numbers) const;

private:
    std::shared_ptr<const engine::Engine> engine_;
};

}  // namespace glassbox
