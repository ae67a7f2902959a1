#include "viewer/model/overlay/surfaces_in_picture.hpp"

#include "render/measure/pixel_numbers.hpp"
#include "viewer/model/state/state.hpp"
#include "viewer/model/work/results.hpp"

namespace glassbox {

const Measurement& surface_met() {
    static constexpr Measurement number{
        "surface",
        "",
        "the number of the surface that is met first",
        Scale::sequential,
        Source::hit,
        {},
        {},
        [](const PixelNumbers& numbers) {
            return std::array<double, 3>{numbers.surface ? static_cast<double>(*numbers.surface) : no_value};
        },
        {},
        {}};
    return number;
}

const SurfacesInPicture* surfaces_in_picture(const ViewerState& state, const Results& results) {
    const SurfacesInPicture* const seen = results.surfaces.get();
    return seen && seen->scene == state.scene && seen->setup == state.setup.now() ? seen : nullptr;
}

std::vector<PixelBorder> outline(const Channel& numbers, std::size_t surface) {
    const auto wanted = static_cast<double>(surface);
    const auto shows = [&](int x, int y) {
        return x >= 0 && y >= 0 && x < numbers.width && y < numbers.height && numbers.at({x, y}) == wanted;
    };
    std::vector<PixelBorder> borders;
    // Along a line between two rows or columns: where just one of its sides shows the surface.
    const auto go_along = [&](int length, const auto& is_border, const auto& add) {
        int from = -1;
        for (int i = 0; i <= length; ++i) {
            const bool here = i < length && is_border(i);
            if (here && from < 0) from = i;
            if (!here && from >= 0) add(std::exchange(from, -1), i);
        }
    };
    for (int y = 0; y <= numbers.height; ++y)
        go_along(
            numbers.width, [&](int x) { return shows(x, y - 1) != shows(x, y); },
            [&](int from, int to) {
                borders.push_back({{from, y}, {to, y}});
            });
    for (int x = 0; x <= numbers.width; ++x)
        go_along(
            numbers.height, [&](int y) { return shows(x - 1, y) != shows(x, y); },
            [&](int from, int to) {
                borders.push_back({{x, from}, {x, to}});
            });
    return borders;
}

}  // namespace glassbox
