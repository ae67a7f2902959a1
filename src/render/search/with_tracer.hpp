#pragma once
#include <utility>

#include "render/lighting.hpp"
#include "render/search/with_search.hpp"
#include "render/tracer.hpp"

namespace glassbox {

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
