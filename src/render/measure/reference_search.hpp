#pragma once
#include <memory>

#include "engine/engine.hpp"
#include "render/measure/pixel_numbers.hpp"
#include "render/options.hpp"

namespace glassbox {

/// Finds the true hits of rays, as the reference for a search; at the same distance the one listed last is nearest. It
/// shares no shortcut with the searches: it tests each surface with running bounds and, if they do not decide, exactly;
/// it skips none that lies behind another, and compares exactly the distances that bounds cannot order. Only in scenes
/// with more surfaces than `few` does it skip those whose boxes the ray surely misses.
class ReferenceSearch {
public:
    static constexpr std::size_t few = 2000;

    /// Searches the surfaces in the engine.
    explicit ReferenceSearch(std::shared_ptr<const engine::Engine> engine) : engine_(std::move(engine)) {}

    /// How many surfaces the ray meets; 0 for a ray that is not valid.
    double hits(const Ray<double>& ray) const;

    /// Fills in the pixel's verdict and, if its surface is right, the bits that its t has lost. `scalar` is the one
    /// that found it.
    void compare(const Ray<double>& ray, Scalar scalar, PixelNumbers& numbers) const;

private:
    std::shared_ptr<const engine::Engine> engine_;
};

}  // namespace glassbox
