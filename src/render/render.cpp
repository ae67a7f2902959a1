#include "render/render.hpp"

#include <probe.hpp>

#include "render/trace_pixels.hpp"

namespace glassbox {

void paint_border(Image& image, Rgb color) {
    for (int x = 0; x < image.width; ++x) image.at(x, 0) = image.at(x, image.height - 1) = color;
    for (int y = 0; y < image.height; ++y) image.at(0, y) = image.at(image.width - 1, y) = color;
}

Image render(const Scene& scene, const Options& options, const Job& job) {
    Image image(scene.width, scene.height);
    trace_pixels<Silent>(scene, options, job,
                         [&](int x, int y, const Ray<double>&, Rgb color, const Silent&) { image.at(x, y) = color; });
    if (scene.border) paint_border(image, *scene.border);
    return image;
}

}  // namespace glassbox
