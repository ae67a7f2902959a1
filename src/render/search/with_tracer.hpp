#pragma once
#include <memory>
#include <utility>

#include "render/job.hpp"
#include "render/lighting.hpp"
#include "render/options.hpp"
#include "render/search/build_engine.hpp"
#include "render/search/certified_search.hpp"
#include "render/search/fast_search.hpp"
#include "render/search/plain_search.hpp"
#include "render/search/probe_flags.hpp"
#include "render/tracer.hpp"

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

/// The search, and how what it finds looks.
template <class Search>
Tracer<Search> tracer_for(Search search, const Scene& scene, const Options& options) {
    using Real = typename Search::Number;
    const auto [L, I, shading] = lighting<Real>(scene);
    const Light<Real> light = directional_light(convert<Real>(L), static_cast<Real>(I));
    return {std::move(search), surface_colors(scene), scene.background, light, convert<Real>(shading), options.stage};
}

/// Calls `use(tracer)` with the tracer that the options name.
template <class Probe, class Use>
auto with_tracer(const Scene& scene, const Options& options, const RayBounds& reach, const Job& job, const Use& use) {
    return with_search<Probe>(scene, options, reach, job, [&]<class Search>(Search search) {
        return use(tracer_for(std::move(search), scene, options));
    });
}

}  // namespace glassbox
