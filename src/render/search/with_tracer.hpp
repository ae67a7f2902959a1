#pragma once
#include <type_traits>
#include <utility>

#include "render/job.hpp"
#include "render/lighting.hpp"
#include "render/options.hpp"
#include "render/search/build_engine.hpp"
#include "render/search/certified_search.hpp"
#include "render/search/fast_search.hpp"
#include "render/search/plain_search.hpp"
#include "render/tracer.hpp"

namespace glassbox {

/// Calls `use(search)` with the search for a scene's surfaces that the options name, for probes of type Probe. `reach`
/// must cover all rays to be traced.
template <class Probe, class Use>
auto with_search(const Scene& scene, const Options& options, const RayBounds& reach, const Job& job, const Use& use) {
    const auto plain = [&]<class Real>(std::type_identity<Real>) {
        return use(PlainSearch<Real, Chosen<SphereRule>, Chosen<TriangleRule>>{
            surfaces<Real>(scene, options.stage), {options.sphere_rule}, {options.triangle_rule}});
    };
    switch (options.scalar) {
        case Scalar::float_:
            return plain(std::type_identity<float>{});
        case Scalar::double_:
            return plain(std::type_identity<double>{});
        case Scalar::long_double:
            return plain(std::type_identity<long double>{});
        case Scalar::certified:
        case Scalar::exact:
            break;
    }
    if (uses_engine(scene, options, OnlyNearest<Probe> && OnlyVerdicts<Probe>))
        return use(FastSearch(job.engine ? job.engine : build_engine(scene, options.stage, job.threads),
                              options.sphere_rule, options.triangle_rule));
    return use(CertifiedSearch(surfaces<double>(scene, options.stage), options.sphere_rule, options.triangle_rule,
                               reach, options.scalar == Scalar::exact));
}

/// Calls `use(tracer)` with the tracer that the options name.
template <class Probe, class Use>
auto with_tracer(const Scene& scene, const Options& options, const RayBounds& reach, const Job& job, const Use& use) {
    return with_search<Probe>(scene, options, reach, job, [&]<class Search>(Search&& search) {
        using Real = typename Search::Number;
        const auto [L, I, shading] = lighting<Real>(scene);
        return use(Tracer<Search>{std::move(search), surface_colors(scene), scene.background,
                                  directional_light(convert<Real>(L), static_cast<Real>(I)), convert<Real>(shading),
                                  options.stage});
    });
}

}  // namespace glassbox
