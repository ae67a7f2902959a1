#pragma once
#include "render/pixel.hpp"

namespace glassbox {

/// A point, or a distance, on the screen or on a picture.
struct Point {
    double x = 0, y = 0;

    bool operator==(const Point&) const = default;
};

/// How a picture lies in the area where it is shown. Positions on the picture count in pixels: pixel (x, y) covers
/// [x, x + 1) × [y, y + 1). Those on the screen count from the area's top left.
struct PictureView {
    double zoom = 1;  ///< screen pixels a pixel
    Point origin;     ///< where on the screen the picture's top-left corner is

    Point on_screen(Point picture) const { return {origin.x + picture.x * zoom, origin.y + picture.y * zoom}; }
    Point on_picture(Point screen) const { return {(screen.x - origin.x) / zoom, (screen.y - origin.y) / zoom}; }
    /// Also for a point outside the picture.
    Pixel pixel_at(Point screen) const;
};

inline constexpr double least_zoom = 1.0 / 64, greatest_zoom = 512;

/// The whole picture, centred, as large as fits.
PictureView fitted(Point area, int width, int height);

/// The same at a zoom of 1, 2, 3 …, so that all pixels look equally large; one that is too large for that, as large as
/// fits.
PictureView fitted_by_whole_multiple(Point area, int width, int height);

/// One to one, or at any zoom, about the middle of the area.
PictureView zoomed_to(const PictureView& view, double zoom, Point area);

/// `factor` times as large; what is at `cursor` stays there.
PictureView zoomed_at(const PictureView& view, double factor, Point cursor);

PictureView moved(const PictureView& view, Point by);

/// Moved as little as needed to keep some of the picture in the area.
PictureView kept_in_sight(const PictureView& view, Point area, int width, int height);

/// Moved as little as needed to show all of a pixel.
PictureView showing(const PictureView& view, Pixel pixel, Point area);

}  // namespace glassbox
