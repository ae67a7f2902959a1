#pragma once
#include <memory>

#include "render/job.hpp"
#include "render/options.hpp"
#include "render/search/build_engine.hpp"
#include "render/search/certified_search.hpp"
#include "render/search/fast_search.hpp"
#include "render/search/plain_search.hpp"
#include "render/search/probe_flags.hpp"

namespace glassbox {

// From options to types: the scalar and the search are chosen here, once for a picture, and all that follows is
// compiled for each of them. (The rules are chosen at run time: see rules.hpp.)

template <class Real>
PlainSearch<Real, Chosen<SphereRule>, Chosen<TriangleRule>> plain_search(const Scene& scene, const Options& options) {
    return {surfaces<Real>(scene, options.stage), {options.sphere_rule}, {options.triangle_rule}};
}

/// The job's engine, or one built for it.
inline std::shared_ptr<const engine::Engine> engine_for(const Scene& scene, const Options& options, const Job& job) {
    return job.engine ? job.engine : build_engine(scene, options.stage, job.threads);
}

/// Calls `use(search)` with the search for a scene's surfaces that the options name, for probes of type Probe. `reach`
/// must cover all rays to be traced.
template <class Probe, class Use>
auto with_search(const Scene& scene, const Options& options, const RayBounds& reach, const Job& job, const Use& use) {
    switch (options.scalar) {
        case Scalar::float_:
            return use(plain_search<float>(scene, options));
        case Scalar::double_:
            return use(plain_search<double>(scene, options));
        case Scalar::long_double:
            return use(plain_search<long double>(scene, options));
        case Scalar::certified:
        case Scalar::exact:
            break;
    }
    if (uses_engine(scene, options, OnlyFirstHit<Probe>))
        return use(FastSearch(engine_for(scene, options, job), options.sphere_rule, options.triangle_rule));
    return use(CertifiedSearch(surfaces<double>(scene, options.stage), options.sphere_rule, options.triangle_rule,
                               reach, options.scalar == Scalar::exact));
}

}  // namespace glassbox
