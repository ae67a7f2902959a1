#include "viewer/model/state/first_pin.hpp"

#include <cstdint>
#include <optional>

#include "viewer/model/state/state.hpp"
#include "viewer/model/work/results.hpp"

namespace glassbox {

namespace {

std::optional<Pixel> nearest_to_middle(const Image& image, Rgb background) {
    std::optional<Pixel> nearest;
    std::int64_t least = 0;
    // Twice the distances, for the middle lies between pixels where a side is even; the border is painted over.
    for (int y = 1; y + 1 < image.height; ++y)
        for (int x = 1; x + 1 < image.width; ++x) {
            if (image.at(x, y) == background) continue;
            const std::int64_t dx = 2 * x + 1 - image.width, dy = 2 * y + 1 - image.height;
            const std::int64_t distance = dx * dx + dy * dy;
            if (nearest && distance >= least) continue;
            nearest = {x, y};
            least = distance;
        }
    return nearest;
}

}  // namespace

void pin_at_first(ViewerState& state, const Results& results) {
    if (!state.pins_at_first) return;
    if (state.pinned) {
        state.pins_at_first = false;
        return;
    }
    const Picture& picture = results.picture;
    const Scene& scene = *state.scene;
    if (results.busy || !picture.image || picture.factor != 1 || picture.image->width != scene.width ||
        picture.image->height != scene.height)
        return;
    state.pins_at_first = false;
    pin(state, nearest_to_middle(*picture.image, scene.background));
}

}  // namespace glassbox
