#pragma once
#include "numerics/bits_lost.hpp"
#include "render/certified_search.hpp"
#include "render/pixel_numbers.hpp"

namespace glassbox {

/// Holds what was found against what is there: Plücker's test and the roots, certified.
class Judge {
public:
    Judge(const Scene& scene, int stage, const Reach& reach)
        : search_(surfaces<double>(scene, stage), Stable{}, Pluecker{}, reach, false) {}

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
    static constexpr double right = 0, wrong_hit = 1, wrong_miss = 2, wrong_surface = 3;

    CertifiedSearch<Stable, Pluecker> search_;
};

}  // namespace glassbox
