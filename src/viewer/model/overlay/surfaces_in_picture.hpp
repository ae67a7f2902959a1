#pragma once
#include <cstddef>
#include <memory>
#include <vector>

#include "render/measure/channel.hpp"
#include "render/measure/measurements.hpp"
#include "render/setup.hpp"
#include "scene/scene.hpp"

namespace glassbox {

struct Results;
struct ViewerState;

/// Which surface each pixel shows.
struct SurfacesInPicture {
    Channel numbers;  ///< `no_value` where none is met
    std::shared_ptr<const Scene> scene;
    Setup setup;  ///< how it was traced
};

/// The number of the surface that a ray meets first, as a measurement.
const Measurement& surface_met();

/// Those of what the state shows; null while they are not known.
const SurfacesInPicture* surfaces_in_picture(const ViewerState& state, const Results& results);

/// A line between pixels, along a row or a column: point (x, y) is the top left corner of pixel (x, y).
struct PixelBorder {
    Pixel from, to;

    bool operator==(const PixelBorder&) const = default;
};

/// The borders between the pixels that show this surface and all others, each as long as it is straight.
std::vector<PixelBorder> outline(const Channel& numbers, std::size_t surface);

}  // namespace glassbox
