#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>

#include "compare/compare_pictures.hpp"
#include "render/render.hpp"

namespace glassbox {

namespace {

using Mapping = std::function<std::optional<Pixel>(int x, int y)>;

/// How many pixels differ if theirs at (x, y) is ours at `place(x, y)`, where that is in the picture.
Explanation placed(std::string words, const Image& theirs, const Image& ours, const Mapping& place) {
    Explanation result{std::move(words), 0, 0};
    for (int y = 0; y < theirs.height; ++y)
        for (int x = 0; x < theirs.width; ++x) {
            const std::optional<Pixel> from = place(x, y);
            if (!from || from->x < 0 || from->y < 0 || from->x >= ours.width || from->y >= ours.height) continue;
            ++result.compared;
            if (theirs.at(x, y) != ours.at(from->x, from->y)) ++result.still_differ;
        }
    return result;
}

/// How many pixels differ if each byte of theirs comes from ours by a curve from 0 to 1. A byte of ours stands for all
/// that are rounded to it, or cut.
Explanation curved(std::string words, const Image& theirs, const Image& ours,
                   const std::function<double(double)>& curve) {
    std::array<std::pair<double, double>, 256> between;
    for (int byte = 0; byte < 256; ++byte) {
        const auto at = [&](int b) { return 255 * curve(std::clamp(b, 0, 255) / 255.0); };
        between[static_cast<std::size_t>(byte)] = {at(byte - 1) - 1, at(byte + 1) + 1};
    }
    const auto fits = [&](std::uint8_t their, std::uint8_t our) {
        const auto& [least, most] = between[our];
        return their >= least && their <= most;
    };
    Explanation result{std::move(words), 0, theirs.pixels.size()};
    for (std::size_t i = 0; i < theirs.pixels.size(); ++i) {
        const Rgb &a = theirs.pixels[i], &b = ours.pixels[i];
        if (!fits(a.red, b.red) || !fits(a.green, b.green) || !fits(a.blue, b.blue)) ++result.still_differ;
    }
    return result;
}

/// A curve counts as one only where no curve at all, as generously compared, does not do as well.
void add_curves(std::vector<Explanation>& all, const Image& theirs, const Image& ours) {
    const std::size_t without = curved("", theirs, ours, [](double c) { return c; }).still_differ;
    const auto add = [&](const char* words, const std::function<double(double)>& curve) {
        Explanation one = curved(words, theirs, ours, curve);
        if (one.still_differ < without / 10 || (one.still_differ == 0 && without > 0)) all.push_back(std::move(one));
    };
    add("with the curve of sRGB applied to it",
        [](double c) { return c <= 0.0031308 ? 12.92 * c : 1.055 * std::pow(c, 1 / 2.4) - 0.055; });
    add("with a gamma of 2.2 applied to it", [](double c) { return std::pow(c, 1 / 2.2); });
    add("with a gamma of 2 applied to it, the square root", [](double c) { return std::sqrt(c); });
    add("with the curve of sRGB taken off it",
        [](double c) { return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4); });
}

Explanation swapped(std::string words, const Image& theirs, Image ours) {
    for (Rgb& color : ours.pixels) std::swap(color.red, color.blue);
    return placed(std::move(words), theirs, ours, [](int x, int y) { return Pixel{x, y}; });
}

/// The scene's picture with so many pixels more on the right and above: these have the same size as before, and all
/// move by half as many to the left and down.
Scene widened(Scene scene, int right, int above) {
    if (auto* v = std::get_if<ParallelView>(&scene.view)) {
        v->corner = v->corner - right / 2.0 * v->right - above / 2.0 * v->up;
    } else {
        double& angle = std::get<PinholeView>(scene.view).field_of_view;
        constexpr double degree = std::numbers::pi / 180;
        angle = 2 / degree * std::atan(std::tan(angle / 2 * degree) * (scene.height + above) / scene.height);
    }
    scene.width += right;
    scene.height += above;
    scene.border.reset();
    return scene;
}

void add_half_pixels(std::vector<Explanation>& all, const Scene& scene, const Options& options, const Image& theirs,
                     const Job& job) {
    constexpr const char* sideways[] = {"", "to the left", "to the right"};
    constexpr const char* upwards[] = {"", "down", "up"};
    for (const auto& [right, above] : {std::pair(1, 0), std::pair(0, 1), std::pair(1, 1)}) {
        const Image wider = render(widened(scene, right, above), options, job);
        for (int dx = 0; dx <= right; ++dx)
            for (int dy = 0; dy <= above; ++dy) {
                // Column dx of the wider picture lies half a pixel to the left of our first one, or to its right. What
                // is seen there is their first: their picture has moved the other way.
                const std::string to_side = sideways[right == 0 ? 0 : dx == 0 ? 2 : 1];
                const std::string up = upwards[above == 0 ? 0 : dy == 0 ? 1 : 2];
                all.push_back(placed("shifted by half a pixel " + to_side + (right + above == 2 ? " and " : "") + up,
                                     theirs, wider, [=, &scene](int x, int y) -> std::optional<Pixel> {
                                         const bool is_edge =
                                             scene.border &&
                                             (x == 0 || y == 0 || x == scene.width - 1 || y == scene.height - 1);
                                         return is_edge ? std::nullopt : std::optional(Pixel{x + dx, y + dy});
                                     }));
            }
    }
}

}  // namespace

std::vector<Explanation> explanations(const Scene& scene, const Options& options, const Image& theirs,
                                      const Image& ours, std::size_t differ, const Job& job) {
    const int last_x = ours.width - 1, last_y = ours.height - 1;
    std::vector<Explanation> all;
    const auto place = [&](const char* words, const Mapping& from) {
        all.push_back(placed(words, theirs, ours, from));
    };
    place("flipped top to bottom", [=](int x, int y) { return Pixel{x, last_y - y}; });
    place("flipped left to right", [=](int x, int y) { return Pixel{last_x - x, y}; });
    place("turned by half a turn", [=](int x, int y) { return Pixel{last_x - x, last_y - y}; });
    if (last_x == last_y) {
        place("with rows and columns swapped", [](int x, int y) { return Pixel{y, x}; });
        place("turned by a quarter to the left", [=](int x, int y) { return Pixel{last_x - y, x}; });
        place("turned by a quarter to the right", [=](int x, int y) { return Pixel{y, last_y - x}; });
    }
    place("shifted by a pixel to the left", [](int x, int y) { return Pixel{x + 1, y}; });
    place("shifted by a pixel to the right", [](int x, int y) { return Pixel{x - 1, y}; });
    place("shifted by a pixel up", [](int x, int y) { return Pixel{x, y + 1}; });
    place("shifted by a pixel down", [](int x, int y) { return Pixel{x, y - 1}; });
    all.push_back(swapped("with red and blue swapped", theirs, ours));
    add_curves(all, theirs, ours);
    if (options.stage > 1) add_half_pixels(all, scene, options, theirs, job);

    // Of a shift, few pixels may be compared: what is left counts as a share of these.
    const auto share = [](const Explanation& one) {
        return static_cast<double>(one.still_differ) / static_cast<double>(std::max<std::size_t>(one.compared, 1));
    };
    const double before = static_cast<double>(differ) / static_cast<double>(ours.pixels.size());
    std::erase_if(all, [&](const Explanation& one) { return !(share(one) < before / 10) || one.compared == 0; });
    std::ranges::stable_sort(all, {}, share);
    all.resize(std::min<std::size_t>(all.size(), 3));
    return all;
}

}  // namespace glassbox
