#include "viewer/model/state/picture_view.hpp"

#include <algorithm>
#include <cmath>

namespace glassbox {

Pixel PictureView::pixel_at(Point screen) const {
    const Point p = on_picture(screen);
    static constexpr double far_off = 1e9;  // within an int's range, and never on a picture
    const auto whole = [](double v) { return static_cast<int>(std::floor(std::clamp(v, -far_off, far_off))); };
    return {whole(p.x), whole(p.y)};
}

namespace {

double greatest_that_fits(Point area, int width, int height) {
    return std::clamp(std::min(area.x / width, area.y / height), least_zoom, greatest_zoom);
}

PictureView centred(double zoom, Point area, int width, int height) {
    return {zoom, {(area.x - width * zoom) / 2, (area.y - height * zoom) / 2}};
}

}  // namespace

PictureView fitted(Point area, int width, int height) {
    return centred(greatest_that_fits(area, width, height), area, width, height);
}

PictureView fitted_by_whole_multiple(Point area, int width, int height) {
    const double fits = greatest_that_fits(area, width, height);
    if (fits < 1) return fitted(area, width, height);
    const PictureView view = centred(std::floor(fits), area, width, height);
    return {view.zoom, {std::round(view.origin.x), std::round(view.origin.y)}};
}

PictureView zoomed_to(const PictureView& view, double zoom, Point area) {
    return zoomed_at(view, zoom / view.zoom, {area.x / 2, area.y / 2});
}

PictureView zoomed_at(const PictureView& view, double factor, Point cursor) {
    const double zoom = std::clamp(view.zoom * factor, least_zoom, greatest_zoom);
    const Point held = view.on_picture(cursor);
    return {zoom, {cursor.x - held.x * zoom, cursor.y - held.y * zoom}};
}

PictureView moved(const PictureView& view, Point by) {
    return {view.zoom, {view.origin.x + by.x, view.origin.y + by.y}};
}

PictureView kept_in_sight(const PictureView& view, Point area, int width, int height) {
    constexpr double rest = 32;  // screen pixels that stay visible
    const auto kept = [&](double origin, double size, double room) {
        const double margin = std::min({rest, size, room});
        return std::clamp(origin, margin - size, room - margin);
    };
    return {view.zoom,
            {kept(view.origin.x, width * view.zoom, area.x), kept(view.origin.y, height * view.zoom, area.y)}};
}

PictureView showing(const PictureView& view, Pixel pixel, Point area) {
    const Point from = view.on_screen({1.0 * pixel.x, 1.0 * pixel.y});
    const auto shift = [&](double start, double room) {
        if (start < 0) return -start;
        return std::min(0.0, room - (start + view.zoom));
    };
    return moved(view, {shift(from.x, area.x), shift(from.y, area.y)});
}

}  // namespace glassbox
