#include "explain/traced_pixel.hpp"

#include <algorithm>
#include <cmath>

#include "render/measure/pixel_numbers.hpp"
#include "render/search/with_tracer.hpp"
#include "render/view.hpp"

namespace glassbox {

namespace {

/// The probe that keeps the surfaces' results.
struct PixelProbe {
    static constexpr bool only_verdicts = true;

    TracedPixel& pixel;

    template <class What, class... Values>
    void operator()(What, const Values&...) const {}

    template <class Real>
    void operator()(told::Met, std::size_t surface, const Real& t) const {
        pixel.met.push_back({surface, static_cast<long double>(t)});
    }

    void operator()(told::Undecided, std::size_t surface) const { pixel.needed_exact.push_back(surface); }

    template <class Real>
    void operator()(told::Nearest, std::size_t surface, const Real& t) const {
        pixel.nearest = Hit<double>{surface, static_cast<double>(t)};
    }

    template <class Real>
    void operator()(told::SurfaceNormal, const Vec3<Real>& n) const {
        pixel.normal = convert<double>(n);
    }
};

/// The plain loop tests every surface; what the engine does, it tells.
void count_tests(const Scene& scene, const Options& options, const Job& job, TracedPixel& pixel) {
    const auto [spheres, triangles] = count_surfaces(scene, options.stage);
    pixel.tested = spheres + triangles;
    if (!uses_engine(scene, options, false) || !is_valid(pixel.ray)) return;
    PixelNumbers heard;
    FastSearch(engine_for(scene, options, job), options.sphere_rule, options.triangle_rule).trace(pixel.ray, heard);
    pixel.tested = static_cast<std::size_t>(heard.tests);
    const auto counted = [](double count) {
        return std::isnan(count) ? std::nullopt : std::optional(static_cast<std::size_t>(count));
    };
    pixel.nodes = counted(heard.nodes);
    pixel.boxes_missed = counted(heard.boxes_missed);
}

}  // namespace

TracedPixel traced_pixel(const Scene& scene, const Options& options, int x, int y, const Job& job) {
    const View seen = view(scene, options);
    TracedPixel result;
    result.ray = pixel_ray(seen, x, y, scene.height);
    with_tracer<PixelProbe>(scene, options, reach(seen, scene.width, scene.height), job,
                            [&]<class Search>(const Tracer<Search>& tracer) {
                                PixelProbe probe{result};
                                const auto ray = convert<typename Search::Number>(result.ray);
                                result.color = tracer.color(ray, x, scene.height - 1 - y, probe);
                            });
    count_tests(scene, options, job, result);
    std::ranges::sort(result.met, {}, &Hit<long double>::surface);  // the engine finds them in another order
    return result;
}

}  // namespace glassbox
