#include "viewer/ui/pictures.hpp"

#include <algorithm>
#include <cstdlib>
#include <utility>
#include <vector>

#include "output/coloring.hpp"

namespace glassbox {

namespace {

std::vector<Rgba> opaque(const Image& image) {
    std::vector<Rgba> pixels;
    pixels.reserve(image.pixels.size());
    for (const Rgb& c : image.pixels) pixels.push_back({c.red, c.green, c.blue, 255});
    return pixels;
}

void fill(Texture& texture, const Image& image) { texture.fill(image.width, image.height, opaque(image)); }

/// What the paper's loops have reached after so many pixels: columns from the left, in each the rows from the bottom.
/// The rest is blank.
std::vector<Rgba> watched(const Image& image, std::size_t shown) {
    std::vector<Rgba> pixels(image.pixels.size(), Rgba{0, 0, 0, 0});
    const auto height = static_cast<std::size_t>(image.height), width = static_cast<std::size_t>(image.width);
    for (std::size_t k = 0; k < std::min(shown, pixels.size()); ++k) {
        const std::size_t pixel = (height - 1 - k % height) * width + k / height;
        const Rgb c = image.pixels[pixel];
        pixels[pixel] = {c.red, c.green, c.blue, 255};
    }
    return pixels;
}

/// Where two pictures are equal: nearly black; where they differ: the difference, eight times as bright.
Image magnified_difference(const Image& one, const Image& other) {
    Image result(one.width, one.height);
    const auto channel = [](std::uint8_t a, std::uint8_t b) {
        return static_cast<std::uint8_t>(std::min(255, 8 * std::abs(int{a} - int{b})));
    };
    for (std::size_t i = 0; i < result.pixels.size(); ++i) {
        const Rgb a = one.pixels[i], b = other.pixels[i];
        result.pixels[i] = {channel(a.red, b.red), channel(a.green, b.green), channel(a.blue, b.blue)};
    }
    return result;
}

}  // namespace

void Pictures::update(const ViewerState& state, const Results& results) {
    const auto renewed = [](std::uint64_t& have, std::uint64_t now) { return std::exchange(have, now) != now; };

    const auto shown = state.watching.running ? static_cast<std::size_t>(state.watching.shown) : 0;
    const bool other_watched = std::exchange(watched_, shown) != shown;
    if ((renewed(picture_serial_, results.picture_serial) || other_watched) && results.picture.image) {
        const Image& image = *results.picture.image;
        if (state.watching.running) picture_.fill(image.width, image.height, watched(image, shown));
        else fill(picture_, image);
    }

    const bool other_choice = std::exchange(overlay_choice_, state.overlay) != state.overlay;
    if ((renewed(overlay_serial_, results.overlay_serial) || other_choice) && results.overlay)
        fill(overlay_, colored({results.overlay->what, results.overlay->planes}));

    if (renewed(other_serial_, results.other_serial) && results.other.image) fill(other_, *results.other.image);
    if (renewed(difference_serial_, results.picture_serial + results.other_serial) && results.other.image &&
        results.picture.image && results.picture.factor == results.other.factor)
        fill(difference_, magnified_difference(*results.picture.image, *results.other.image));
}

}  // namespace glassbox
