#include <algorithm>
#include <optional>

#include "render/judge.hpp"
#include "render/render.hpp"
#include "render/trace_pixels.hpp"

namespace glassbox {

namespace {

/// Calls `use` with a value of the scalar's type.
template <class Use>
void with_number(Scalar scalar, const Use& use) {
    switch (scalar) {
        case Scalar::float_:
            return use(float{});
        case Scalar::long_double:
            return use(0.0L);
        default:
            return use(double{});
    }
}

std::vector<Plane> empty_planes(const Measurement& measurement, int width, int height) {
    const std::size_t pixels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    std::vector<Plane> planes;
    for (const std::string_view name : measurement.planes)
        planes.push_back({std::string(name), width, height, std::vector<double>(pixels, no_value)});
    return planes;
}

}  // namespace

std::vector<std::vector<Plane>> measure(const Scene& scene, const Options& options,
                                        std::span<const Measurement* const> wanted, const Job& job) {
    const View rebuilt = rebuilt_view(scene, turns_of(options));
    const View accumulated = accumulated_view(scene, turns_of(options));
    std::optional<Judge> judge;
    if (std::any_of(wanted.begin(), wanted.end(), [](const Measurement* m) { return m->needs_truth; }))
        judge.emplace(scene, options.stage, reach(view(scene, options), scene.width, scene.height));

    std::vector<std::vector<Plane>> result;
    for (const Measurement* measurement : wanted)
        result.push_back(empty_planes(*measurement, scene.width, scene.height));

    trace_pixels<PixelNumbers>(
        scene, options, job, [&](int x, int y, const Ray<double>& ray, Rgb, PixelNumbers& numbers) {
            numbers.drift =
                length(pixel_ray(rebuilt, x, y, scene.height).P - pixel_ray(accumulated, x, y, scene.height).P);
            if (is_proven(options.scalar)) numbers.undecided = static_cast<double>(numbers.exact_tests);
            if (judge) with_number(options.scalar, [&]<class Real>(Real) { judge->judge<Real>(ray, numbers); });
            const std::size_t pixel =
                static_cast<std::size_t>(y) * static_cast<std::size_t>(scene.width) + static_cast<std::size_t>(x);
            for (std::size_t m = 0; m < wanted.size(); ++m) {
                const std::array<double, 3> values = wanted[m]->read(numbers);
                for (std::size_t p = 0; p < result[m].size(); ++p) result[m][p].values[pixel] = values[p];
            }
        });
    return result;
}

}  // namespace glassbox
