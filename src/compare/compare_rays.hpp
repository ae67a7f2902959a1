#pragma once
#include <array>
#include <span>
#include <vector>

#include "compare/cause.hpp"
#include "compare/hits_file.hpp"
#include "compare/sight.hpp"
#include "render/job.hpp"
#include "render/options.hpp"
#include "scene/scene.hpp"

namespace glassbox {

/// In what an answer differs from the truth.
enum class Wrong { nothing, validity, hit, miss, surface, t };
inline constexpr std::size_t wrong_count = 6;

/// One ray about which another program and the truth differ.
struct RayDifference {
    std::size_t ray = 0;
    Wrong wrong = Wrong::nothing;
    Cause cause = Cause::same;
    std::vector<CloseCall> calls;
    std::optional<double> t_off;  ///< their t − the certified t of the surface that they name, if both are there
    double t_bound = 0;           ///< what rounding may do to that t; infinite: no bound is known
    double times = 0;             ///< how many times as far as rounding reaches: what ranks mistakes
};

/// All rays together.
struct RayComparison {
    std::vector<Shot> ours;                  ///< true, each
    std::vector<RayDifference> differences;  ///< ties too, in the order of the rays

    std::size_t count(Cause cause) const;
    std::size_t count(Wrong wrong, Cause cause) const;
    /// Those about which they differ: all but ties.
    std::size_t count() const { return differences.size() - count(Cause::tie); }
};

/// Whose rounding is asked about.
struct Theirs {
    TheirPrecision precision = TheirPrecision::double_;
    Formulas formulas;
};

/// Compares what another program says with the truth, for each ray. The options' scalar must be a proven one. `truth`
/// is what an earlier comparison of these rays found, `RayComparison::ours`; without it they are traced. Throws
/// Cancelled.
RayComparison compare_rays(const Scene& scene, const Options& options, std::span<const Ray<double>> rays,
                           const Claims& claims, const Theirs& theirs, const Job& job, std::vector<Shot> truth = {});

}  // namespace glassbox
