#pragma once
#include "numerics/bits_lost.hpp"
#include "render/fast_search.hpp"
#include "render/pixel_numbers.hpp"

namespace glassbox {

/// Holds what was found against what is there: Plücker's test and the roots, certified.
class Judge {
public:
    /// Of the surfaces in the engine.
    explicit Judge(std::shared_ptr<const engine::Engine> engine) : search_(std::move(engine), Stable{}, Pluecker{}) {}

    /// How many surfaces the ray meets.
    double hits(const Ray<double>& ray) const {
        if (!is_valid(ray)) return 0;
        Met met;
        search_.trace_proven(ray, met);
        return met.count;
    }

    /// Fills in the pixel's verdict and, where it found the right surface, the bits that its t has lost. `Real` is the
    /// scalar that found it.
    template <class Real>
    void judge(const Ray<double>& ray, PixelNumbers& numbers) const {
        if (!is_valid(ray)) return;
        const Silent silent;
        const std::optional<ProvenHit> truth = search_.trace_proven(ray, silent);
        numbers.verdict = !truth && !numbers.surface           ? right
                          : !truth                             ? wrong_hit
                          : !numbers.surface                   ? wrong_miss
                          : *numbers.surface == truth->surface ? right
                                                               : wrong_surface;
        if (truth && numbers.verdict == right)
            numbers.bits_lost = bits_lost(static_cast<Real>(numbers.found_t), *search_.true_t(ray, truth->surface));
    }

private:
    struct Met {
        static constexpr bool only_verdicts = true;
        double count = 0;

        template <class What, class... Values>
        void operator()(What, const Values&...) {
            if constexpr (std::is_same_v<What, told::Met>) ++count;
        }
    };

    static constexpr double right = 0, wrong_hit = 1, wrong_miss = 2, wrong_surface = 3;

    FastSearch<Stable, Pluecker> search_;
};

}  // namespace glassbox
