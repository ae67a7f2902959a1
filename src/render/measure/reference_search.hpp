#pragma once
#include <memory>

#include "engine/engine.hpp"
#include "render/measure/pixel_numbers.hpp"
#include "render/options.hpp"
#include "render/search/exact_crossing.hpp"

namespace glassbox {

/// The true hits of a ray.
struct TrueHits {
    std::size_t hits = 0;                ///< surfaces that it meets
    std::optional<std::size_t> nearest;  ///< at the same distance, the one listed last
    std::optional<TrueT> t;              ///< of the nearest
};

/// Finds the true hits of rays, as the reference for a search. It shares no shortcut with the searches: it tests each
/// surface with running bounds and, if they do not decide, exactly; it skips none that lies behind another, and
/// compares exactly the distances that bounds cannot order. Only in scenes with more surfaces than `few` does it skip
/// those whose boxes the ray surely misses.
class ReferenceSearch {
public:
    static constexpr std::size_t few = 2000;

    /// Searches the surfaces in the engine.
    explicit ReferenceSearch(std::shared_ptr<const engine::Engine> engine) : engine_(std::move(engine)) {}

    /// `ray` must be valid.
    TrueHits true_hits(const Ray<double>& ray) const;

    /// How many surfaces the ray meets.
    double hits(const Ray<double>& ray) const { return is_valid(ray) ? static_cast<double>(true_hits(ray).hits) : 0; }

    /// Fills in the pixel's verdict and, if its surface is right, the bits that its t has lost. `scalar` is the one
    /// that found it.
    void compare(const Ray<double>& ray, Scalar scalar, PixelNumbers& numbers) const;

private:
    std::shared_ptr<const engine::Engine> engine_;
};

}  // namespace glassbox
