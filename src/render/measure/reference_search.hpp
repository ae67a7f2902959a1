#pragma once
#include <memory>
#include <optional>
#include <vector>

#include "engine/engine.hpp"
#include "engine/function_ref.hpp"
#include "render/measure/pixel_numbers.hpp"
#include "render/options.hpp"

namespace glassbox {

/// How what is found compares with the truth. The numbers are those of the measurement `verdict`.
enum class Verdict { right = 0, wrong_hit = 1, wrong_miss = 2, wrong_surface = 3 };

/// Compares the surface that was found nearest with the one that is.
Verdict verdict(const std::optional<std::size_t>& found, const std::optional<std::size_t>& truth);

/// The surfaces that a ray truly meets.
struct TrueHits {
    std::vector<std::size_t> met;        ///< all, in the order of their numbers
    std::optional<std::size_t> nearest;  ///< none if the ray meets nothing
    bool needed_exact = false;           ///< bounds left open a sign or an order, which exact arithmetic decided

    bool has(std::size_t surface) const;
};

/// Finds the true hits of rays, as the reference for a search; at the same distance the one listed last is nearest. It
/// shares no shortcut with the searches: it tests each surface with running bounds and, if they do not decide, exactly;
/// it skips none that lies behind another, and compares exactly the distances that bounds cannot order. Only in scenes
/// with more surfaces than `few` does it skip those whose boxes the ray surely misses.
class ReferenceSearch {
public:
    static constexpr std::size_t few = 2000;

    /// Searches the surfaces in the engine.
    explicit ReferenceSearch(std::shared_ptr<const engine::Engine> engine) : engine_(std::move(engine)) {}

    /// None for a ray that is not valid.
    TrueHits hits(const Ray<double>& ray) const;

    /// Which of two surfaces that the ray truly meets it meets first: -1 for `one`, 1 for `other`, 0 if both at once.
    int order(const Ray<double>& ray, std::size_t one, std::size_t other) const;

    /// Calls `ask` with the number of each surface that is tested. The ray must be valid.
    void for_each_tested(const Ray<double>& ray, engine::FunctionRef<void(std::size_t)> ask) const;

    /// Fills in the pixel's verdict and, if its surface is right, the bits that its t has lost. `scalar` is the one
    /// that found it.
    void compare(const Ray<double>& ray, Scalar scalar, PixelNumbers& numbers) const;

private:
    std::shared_ptr<const engine::Engine> engine_;
};

}  // namespace glassbox
