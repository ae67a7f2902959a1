#pragma once
#include "viewer/model/space/space.hpp"
#include "viewer/ui/panels.hpp"

namespace glassbox {

/// The area of the screen where the scene in space is drawn, and the camera that sees it.
struct SpaceCanvas {
    const Frame& frame;
    const SurfacesInSpace& surfaces;
    const SpaceDrawing& drawing;
    ImDrawList& list;
    ImVec2 corner;  ///< of the place
    Camera camera;

    ImVec2 on_screen(const Vec3<double>& point) const {
        const Point p = project(camera, point).at;
        return {corner.x + static_cast<float>(p.x), corner.y + static_cast<float>(p.y)};
    }
};

/// Returns the palette's colour for an ink.
ImU32 color_of(const Palette& palette, Ink ink);

/// Returns the same colour with that part of its opacity.
ImU32 faded(ImU32 color, double part);

/// The usual width of a line, in pixels.
float line_width();

/// Draws surfaces, the picture, boxes and lines, the farthest first; then once more, faintly, all lines and the boxes
/// that the pinned ray meets, so that none is hidden.
void paint_sorted(const SpaceCanvas& canvas);

/// Draws the visible part of a straight line.
void paint_line(const SpaceCanvas& canvas, const Vec3<double>& from, const Vec3<double>& to, ImU32 color, float width);

/// Draws an arrow, and returns where its tip is on the screen; none if it is behind the camera.
std::optional<ImVec2> paint_arrow(const SpaceCanvas& canvas, const Vec3<double>& from, const Vec3<double>& to,
                                  ImU32 color, float width);

}  // namespace glassbox
