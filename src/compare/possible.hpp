#pragma once
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <kleene.hpp>

#include "engine/engine.hpp"
#include "numerics/enclosure.hpp"
#include "render/rules.hpp"

namespace glassbox {

/// The formulas that another program may compute with. Rounding explains what one of them may come to.
struct Formulas {
    std::vector<SphereRule> spheres{Stable{}, Textbook{}};
    std::vector<TriangleRule> triangles{Pluecker{}, MoellerTrumbore{}};
};

/// A number whose sign decides something about a surface, as the first of the formulas computes it.
struct Decider {
    std::string what;  ///< "side product a", "Δ", "t"; empty: none is known
    double value = 0;  ///< near the true number
    double error = 0;  ///< no rounding moves it further than this; infinite or NaN: nothing is known
    /// How many times the error it is away from 0, at least; 0 if nothing is known.
    double times() const { return value == 0 || !(error >= 0) ? 0 : std::abs(value) / error; }
};

/// What may become of a ray's test with one surface, however it is rounded.
struct Possible {
    /// Surely: each formula meets it. Not possibly: each of them misses it.
    Kleene met = false;
    /// All t that may be computed, in units of |D|; infinite ends where the bound says nothing.
    double least_t = 0, most_t = 0;
    /// The formulas, of those in question, that leave open whether it is met: "stable", "pluecker with unit D".
    std::vector<std::string> undecided_by;
    /// Whether the numbers that decide have bounds: they do not overflow.
    bool has_bounds = true;
    /// What the verdict hangs on.
    Decider decider;

    bool may_be_met() const { return possibly(met); }
    bool may_be_missed() const { return !surely(met); }
    bool may_have(double t, double give_or_take) const {
        return t >= least_t - give_or_take && t <= most_t + give_or_take;
    }
};

/// Tests one surface by all formulas, each with D as it is and with D made a unit vector, in the scalar Real. `is_met`
/// is the truth, which says what the verdict hangs on.
template <class Real>
Possible possible(const Ray<Enclosure<Real>>& ray, const engine::Engine& surfaces, std::size_t surface, bool is_met,
                  const Formulas& formulas);

extern template Possible possible(const Ray<Enclosure<float>>&, const engine::Engine&, std::size_t, bool,
                                  const Formulas&);
extern template Possible possible(const Ray<Enclosure<double>>&, const engine::Engine&, std::size_t, bool,
                                  const Formulas&);

}  // namespace glassbox
