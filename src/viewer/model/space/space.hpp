#pragma once
#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "render/search/surfaces.hpp"
#include "viewer/model/space/camera.hpp"
#include "viewer/model/state/state.hpp"
#include "viewer/model/work/results.hpp"

namespace glassbox {

// What the space view shows, in the world's coordinates. The ui room projects and draws it.

/// The meanings of colours in space.
enum class Ink { plain, faint, pinned, second, light, viewer, half_vector, a, b, c };

/// The surfaces that are drawn: all, or of very many triangles fewer and larger ones, or a sample.
struct SurfacesInSpace {
    Surfaces<double> shown;
    std::vector<std::size_t> numbers;                ///< in the scene, of those shown: spheres, then triangles
    std::vector<Rgb> colors;                         ///< likewise
    std::vector<std::array<Vec3<double>, 2>> boxes;  ///< least and greatest corner of what is drawn only in part
    std::size_t all_spheres = 0, all_triangles = 0;  ///< how many there are
    bool coarser = false;  ///< the triangles are fewer and larger than the scene's, their numbers those of one of many
    double side = 0;       ///< the mean of a coarser triangle's sides
    std::size_t far = 0;   ///< how many lie beyond the ball of sight

    /// A part of a triangle, small enough to be sorted by the depth of its middle.
    struct Part {
        std::array<Vec3<double>, 3> corners;
        std::uint32_t triangle;           ///< an index into `shown.triangles`
        std::array<bool, 3> on_its_edge;  ///< whether corner i to i + 1 lies on an edge that is drawn with the triangle
    };
    std::vector<Part> parts;

    Ball sight;                         ///< holds the picture and what is near it, with the view unturned
    std::vector<Vec3<double>> outline;  ///< points of it that reach as far as all of it
    Upright upright;                    ///< of the view unturned
    double nearest = 0;                 ///< the distance of the surface nearest to the unturned picture's eye or plane
};

/// A line of the drawing.
struct LineInSpace {
    Vec3<double> from, to;
    Ink ink = Ink::plain;
    bool dashed = false;
    double width = 1;  ///< times that of a usual line
};

/// A direction drawn from a point, as an arrow of a length that can be read.
struct ArrowInSpace {
    Vec3<double> from, direction;  ///< a unit vector
    Ink ink = Ink::plain;
    const char* name = "";
};

/// Words at a point, with or without a dot.
struct LabelInSpace {
    Vec3<double> at;
    std::string text;
    Ink ink = Ink::plain;
    bool dot = false;
    std::string hint;  ///< what is said of it under the mouse
    double room = 0;   ///< the size of what it belongs to: no words where that looks too small
};

/// The picture in space: where its corners are, and how it is reached.
struct PictureInSpace {
    View view;
    int width = 1, height = 1;  ///< of the scene's picture, in pixels
    double t = 0;               ///< of its pixels' rays: 0 where they start, 1 on a pinhole's viewing plane

    /// The point (x, y) of the picture, in pixels from its top left: pixel (i, j) covers [i, i + 1) × [j, j + 1).
    Vec3<double> at(double x, double y) const;
    /// Returns the point of the picture that a ray meets ahead of its start, if any.
    std::optional<Point> met_by(const Ray<double>& ray) const;
};

/// All that changes when the view turns, the light moves or a pixel is pinned.
struct SpaceDrawing {
    PictureInSpace picture;
    Ball sight;                         ///< that of the surfaces, large enough for the turned picture
    std::vector<Vec3<double>> outline;  ///< points that reach as far as all that is in sight
    double near = .2;                   ///< the orbit's distance at which the first hit's surface is large
    Vec3<double> focus;                 ///< what coming closer leads to: the first hit, or the middle of all
    Vec3<double> light;                 ///< the unit vector towards it
    bool has_light = false;             ///< from stage 4 on, and if it has a direction
    Vec3<double> axes_at;               ///< the world's origin, or if that is out of sight another point
    double axis_length = 1;             ///< of the world's axes
    std::vector<LineInSpace> lines;
    std::vector<ArrowInSpace> arrows;
    std::vector<LabelInSpace> labels;
};

/// Returns the surfaces of a stage: at most `most_spheres`; all triangles, or of more than `most_triangles` so many
/// coarser ones; where these would leave nothing of the shape, about `sample` of them.
SurfacesInSpace surfaces_in_space(const Scene& scene, int stage, std::size_t most_spheres = 400,
                                  std::size_t most_triangles = 3000, std::size_t sample = 1000);

/// Whether the edges of triangles are worth drawing: those of coarser ones are not the scene's, and where they lie
/// close together they only tint the surface.
bool edges_are_seen(const SurfacesInSpace& surfaces, const Camera& camera);

SpaceDrawing space_drawing(const Scene& scene, const Setup& setup, const SurfacesInSpace& surfaces, const Story* pinned,
                           const Story* compared);

/// Keeps both between frames, as long as they are valid.
class Space {
public:
    void update(const ViewerState& state, const Results& results);

    const SurfacesInSpace& surfaces() const { return surfaces_; }
    const SpaceDrawing& drawing() const { return drawing_; }

private:
    SurfacesInSpace surfaces_;
    SpaceDrawing drawing_;
    std::shared_ptr<const Scene> scene_;
    int stage_ = 0;
    std::optional<Setup> setup_;
    std::shared_ptr<const Story> pinned_, compared_;
};

/// What lies nearest to the camera at a point of the screen.
struct SeenInSpace {
    std::optional<std::size_t> surface;  ///< its number
    std::optional<Point> on_picture;
};
SeenInSpace seen_at(const Camera& camera, Point screen, const SurfacesInSpace& surfaces, const SpaceDrawing& drawing);

}  // namespace glassbox
