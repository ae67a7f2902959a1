#include "render/render.hpp"

#include <probe.hpp>

#include "render/parallel.hpp"
#include "render/pixel_numbers.hpp"
#include "render/tracer.hpp"
#include "render/view.hpp"

namespace glassbox {

namespace {

void paint_border(Image& image, Rgb color) {
    for (int x = 0; x < image.width; ++x) image.at(x, 0) = image.at(x, image.height - 1) = color;
    for (int y = 0; y < image.height; ++y) image.at(0, y) = image.at(image.width - 1, y) = color;
}

/// Traces the ray of every pixel and hands its colour and its probe to `keep(x, y, color, probe)`.
template <class Probe, class Keep>
void trace_pixels(const Scene& scene, const Options& options, const Job& job, const Keep& keep) {
    const View seen = view(scene, options.stage >= 5 ? std::span(options.turns) : std::span<const Turn<double>>{});
    const Reach all = reach(seen, scene.width, scene.height);
    with_tracer(scene, options, all, [&]<class Search>(const Tracer<Search>& tracer) {
        for_each_pixel(scene.width, scene.height, job, [&](int x, int y) {
            const auto ray = convert<typename Search::Number>(pixel_ray(seen, x, y, scene.height));
            Probe probe;
            const Rgb color = tracer.color(ray, x, scene.height - 1 - y, probe);
            keep(x, y, color, probe);
        });
    });
}

}  // namespace

Image render(const Scene& scene, const Options& options, const Job& job) {
    Image image(scene.width, scene.height);
    trace_pixels<Silent>(scene, options, job, [&](int x, int y, Rgb color, const Silent&) { image.at(x, y) = color; });
    if (scene.border) paint_border(image, *scene.border);
    return image;
}

std::vector<std::vector<Plane>> measure(const Scene& scene, const Options& options,
                                        std::span<const Measurement* const> wanted, const Job& job) {
    const std::size_t pixels = static_cast<std::size_t>(scene.width) * static_cast<std::size_t>(scene.height);
    std::vector<std::vector<Plane>> result;
    for (const Measurement* measurement : wanted) {
        auto& planes = result.emplace_back();
        for (const std::string_view name : measurement->planes)
            planes.push_back({std::string(name), scene.width, scene.height, std::vector<double>(pixels, no_value)});
    }
    trace_pixels<PixelNumbers>(scene, options, job, [&](int x, int y, Rgb, const PixelNumbers& numbers) {
        const std::size_t pixel =
            static_cast<std::size_t>(y) * static_cast<std::size_t>(scene.width) + static_cast<std::size_t>(x);
        for (std::size_t m = 0; m < wanted.size(); ++m)
            for (std::size_t p = 0; p < result[m].size(); ++p) result[m][p].values[pixel] = wanted[m]->read(numbers)[p];
    });
    return result;
}

}  // namespace glassbox
