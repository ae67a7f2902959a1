#include "viewer/model/space/space.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <set>
#include <type_traits>

#include <probe.hpp>
#include <reflection.hpp>

#include "explain/words.hpp"
#include "output/legend_number.hpp"
#include "render/view.hpp"
#include "viewer/model/space/coarser.hpp"

namespace glassbox {

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

struct Box {
    Vec3<double> least{infinite, infinite, infinite}, greatest{-infinite, -infinite, -infinite};

    void add(const Vec3<double>& p) {
        least = {std::min(least.x, p.x), std::min(least.y, p.y), std::min(least.z, p.z)};
        greatest = {std::max(greatest.x, p.x), std::max(greatest.y, p.y), std::max(greatest.z, p.z)};
    }
};

/// Returns a ball that contains the surface.
Ball around(const Sphere<double>& sphere) { return {sphere.C, sphere.r}; }
Ball around(const Triangle<double>& triangle) {
    const auto& [A, B, C] = triangle;
    const Vec3<double> middle = (A + B + C) / 3;
    return {middle, std::max({length(A - middle), length(B - middle), length(C - middle)})};
}

/// Each corner's ray at its t.
std::array<Vec3<double>, 4> corners(const PictureInSpace& picture) {
    const double w = picture.width, h = picture.height;
    return {picture.at(0, 0), picture.at(w, 0), picture.at(w, h), picture.at(0, h)};
}

bool starts_at_eye(const View& view) { return std::holds_alternative<FromEye>(view); }

/// What the distance of surfaces is measured from.
Vec3<double> standpoint(const PictureInSpace& picture) {
    if (const auto* pinhole = std::get_if<FromEye>(&picture.view)) return pinhole->eye;
    return picture.at(picture.width / 2.0, picture.height / 2.0);
}

template <class Use>
void for_each_surface(const Surfaces<double>& surfaces, const Use& use) {
    for (const auto& sphere : surfaces.spheres) use(sphere);
    for (const auto& triangle : surfaces.triangles) use(triangle);
}

/// Returns the largest distance from the standpoint at which the camera still makes room for a surface. A picture may
/// show surfaces millions of times farther away than it is wide: then neither would be visible.
double reach_of_sight(const Surfaces<double>& all, const PictureInSpace& picture) {
    const Vec3<double> from = standpoint(picture);
    std::vector<double> distances;
    for_each_surface(all, [&](const auto& surface) {
        const Ball ball = around(surface);
        distances.push_back(std::max(0.0, length(ball.center - from) - ball.radius));
    });
    if (distances.empty()) return 0;
    // A pinhole's picture has no size of its own: take the surfaces' median distance.
    if (starts_at_eye(picture.view)) {
        const auto middle = distances.begin() + static_cast<std::ptrdiff_t>(distances.size() / 2);
        std::nth_element(distances.begin(), middle, distances.end());
        return 4 * *middle;
    }
    const auto edge = corners(picture);
    return std::max(5 * length(edge[2] - edge[0]), 1.05 * *std::min_element(distances.begin(), distances.end()));
}

/// Directions all around, the nearest neighbours some 30 degrees apart.
std::vector<Vec3<double>> directions_around() {
    std::vector<Vec3<double>> directions;
    for (const int x : {-2, -1, 0, 1, 2})
        for (const int y : {-2, -1, 0, 1, 2})
            for (const int z : {-2, -1, 0, 1, 2})
                if (std::max({std::abs(x), std::abs(y), std::abs(z)}) == 2)
                    directions.push_back({1.0 * x, 1.0 * y, 1.0 * z});
    return directions;
}

/// Of many points those that reach farthest in some direction. They are all looked at once, in all directions.
std::vector<Vec3<double>> farthest(const std::vector<Vec3<double>>& points) {
    struct Farthest {
        Vec3<double> direction, point;
        double reach = -infinite;
    };
    std::vector<Farthest> all;
    for (const Vec3<double>& direction : directions_around()) all.push_back({direction, {}});
    for (const Vec3<double>& point : points)
        for (Farthest& one : all)
            if (const double reach = dot(point, one.direction); reach > one.reach) one.reach = reach, one.point = point;
    std::vector<Vec3<double>> result;
    for (const Farthest& one : all)
        if (one.reach > -infinite) result.push_back(one.point);
    return result;
}

/// Finds a ball around the picture and all surfaces within reach.
void find_sight(SurfacesInSpace& result, const Surfaces<double>& all, const PictureInSpace& picture) {
    const Vec3<double> from = standpoint(picture);
    const double reach = reach_of_sight(all, picture);
    const auto pulled_in = [&](const Vec3<double>& p) {
        const double distance = length(p - from);
        return distance > reach ? from + (reach / distance) * (p - from) : p;
    };
    std::vector<Vec3<double>> points;
    for (const Vec3<double>& corner : corners(picture)) points.push_back(corner);
    points.push_back(from);
    result.nearest = infinite;
    for_each_surface(all, [&]<class Surface>(const Surface& surface) {
        const Ball ball = around(surface);
        const double distance = length(ball.center - from) - ball.radius;
        result.nearest = std::min(result.nearest, distance);
        if (!(distance <= reach)) {
            ++result.far;
            return;
        }
        if constexpr (std::is_same_v<Surface, Triangle<double>>) {
            for (const Vec3<double>& corner : {surface.A, surface.B, surface.C}) points.push_back(pulled_in(corner));
        } else {
            for (const Vec3<double>& axis : {Vec3<double>{1, 0, 0}, Vec3<double>{0, 1, 0}, Vec3<double>{0, 0, 1}})
                for (const double r : {-ball.radius, ball.radius}) points.push_back(pulled_in(ball.center + r * axis));
        }
    });
    std::erase_if(points, [](const Vec3<double>& point) { return !is_finite(point); });
    Box box;
    for (const Vec3<double>& point : points) box.add(point);
    result.sight = {(box.least + box.greatest) / 2, 0};
    for (const Vec3<double>& point : points)
        result.sight.radius = std::max(result.sight.radius, length(point - result.sight.center));
    if (!(result.sight.radius > 0)) result.sight.radius = 1;
    result.outline = farthest(points);
}

/// Halves the longest side until none is longer than `longest`. Neighbours halve a common side alike, so they fit.
void split(std::vector<SurfacesInSpace::Part>& parts, SurfacesInSpace::Part part, double longest, int depth) {
    const auto& [A, B, C] = part.corners;
    const std::array<double, 3> sides{length(B - A), length(C - B), length(A - C)};
    const auto first = static_cast<std::size_t>(std::max_element(sides.begin(), sides.end()) - sides.begin());
    if (depth == 0 || !(sides[first] > longest)) {
        parts.push_back(part);
        return;
    }
    const std::size_t second = (first + 1) % 3, third = (first + 2) % 3;
    const Vec3<double> middle = (part.corners[first] + part.corners[second]) / 2;
    const auto& edge = part.on_its_edge;
    split(parts, {{part.corners[first], middle, part.corners[third]}, part.triangle, {edge[first], false, edge[third]}},
          longest, depth - 1);
    split(parts,
          {{middle, part.corners[second], part.corners[third]}, part.triangle, {edge[first], edge[second], false}},
          longest, depth - 1);
}

double mean_side(const std::vector<Triangle<double>>& triangles) {
    double sum = 0;
    for (const auto& [A, B, C] : triangles) sum += length(B - A) + length(C - B) + length(A - C);
    return sum / (3 * static_cast<double>(triangles.size()));
}

/// Tells whether an edge is new, whichever way it runs: of many triangles, an edge that two share is drawn once.
class Edges {
public:
    explicit Edges(std::size_t triangles) : are_many_(triangles > 200) {}

    bool is_new(const Vec3<double>& from, const Vec3<double>& to) {
        if (!are_many_ || !is_finite(from) || !is_finite(to)) return true;
        const std::array a{from.x, from.y, from.z}, b{to.x, to.y, to.z};
        return seen_.insert(std::minmax(a, b)).second;
    }

private:
    using Point = std::array<double, 3>;
    bool are_many_;
    std::set<std::pair<Point, Point>> seen_;
};

void split_triangles(SurfacesInSpace& result) {
    constexpr int most_halvings = 9;
    Edges edges(result.shown.triangles.size());
    for (std::uint32_t i = 0; i < result.shown.triangles.size(); ++i) {
        const auto& [A, B, C] = result.shown.triangles[i];
        split(result.parts, {{A, B, C}, i, {edges.is_new(A, B), edges.is_new(B, C), edges.is_new(C, A)}},
              result.sight.radius / 6, most_halvings);
    }
}

Vec3<double> values(const story::Vector& v) { return {v.x.value, v.y.value, v.z.value}; }

std::string point_text(const Vec3<double>& v) {
    return fmt::format("({}, {}, {})", legend_number(v.x), legend_number(v.y), legend_number(v.z));
}

/// The drawing under construction.
struct Drawer {
    const SurfacesInSpace& surfaces;
    SpaceDrawing result;

    void line(const Vec3<double>& from, const Vec3<double>& to, Ink ink, double width = 1, bool dashed = false) {
        if (is_finite(from) && is_finite(to)) result.lines.push_back({from, to, ink, dashed, width});
    }
    void arrow(const Vec3<double>& from, const Vec3<double>& direction, Ink ink, const char* name) {
        if (is_finite(from) && is_finite(direction) && direction != Vec3<double>{})
            result.arrows.push_back({from, direction, ink, name});
    }
    void label(const Vec3<double>& at, std::string text, Ink ink, bool dot = false, std::string hint = {},
               double room = 0) {
        if (is_finite(at)) result.labels.push_back({at, std::move(text), ink, dot, std::move(hint), room});
    }
};

/// Returns the t at which a pinhole's rays reach the drawn picture. On the viewing plane itself, at 1, it may be too
/// small to be seen, or lie inside what it shows.
double t_of_picture(const View& view, int height, const SurfacesInSpace& surfaces) {
    const auto* pinhole = std::get_if<FromEye>(&view);
    if (!pinhole) return 0;
    const double wanted = 0.3 * surfaces.sight.radius / (height * length(pinhole->plane.up));
    return std::min(wanted, std::max(0.6 * surfaces.nearest, wanted / 4));
}

void draw_outline(Drawer& drawer, const std::array<Vec3<double>, 4>& corner, Ink ink) {
    for (std::size_t i = 0; i < 4; ++i) drawer.line(corner[i], corner[(i + 1) % 4], ink);
}

void draw_view(Drawer& drawer, bool with_name_of_eye) {
    const PictureInSpace& picture = drawer.result.picture;
    const auto corner = corners(picture);
    draw_outline(drawer, corner, Ink::faint);
    if (const auto* pinhole = std::get_if<FromEye>(&picture.view)) {
        PictureInSpace plane = picture;
        plane.t = 1;
        draw_outline(drawer, corners(plane), Ink::faint);
        for (const Vec3<double>& c : corner) drawer.line(pinhole->eye, c, Ink::faint);
        if (with_name_of_eye)
            drawer.label(pinhole->eye, "eye", Ink::faint, true,
                         "The eye, where all rays start: " + point_text(pinhole->eye));
    }
}

struct MetSurface {
    const story::Surface* surface;
    double t;
};

std::vector<MetSurface> met_in_order(const Story& story) {
    std::vector<MetSurface> met;
    for (const story::Surface& surface : story.surfaces)
        if (is_met(surface.fate) && surface.t) met.push_back({&surface, surface.t->value});
    // The surface that the story calls nearest comes first, also among equals.
    std::stable_sort(met.begin(), met.end(), [](const MetSurface& a, const MetSurface& b) {
        const bool a_first = a.surface->fate == story::Fate::nearest, b_first = b.surface->fate == story::Fate::nearest;
        return a_first != b_first ? a_first : a.t < b.t;
    });
    return met;
}

void draw_exit(Drawer& drawer, const Story& story, const MetSurface& met, Ink ink) {
    const auto* sphere = std::get_if<story::SphereTest>(&met.surface->test);
    if (!sphere) return;
    const story::RootPair& roots =
        std::holds_alternative<Stable>(story.options.sphere_rule) ? sphere->stable : sphere->textbook;
    if (!roots.t1 || !(roots.t1->value > met.t)) return;
    drawer.label(at(story.ray, roots.t1->value), "", ink, true,
                 fmt::format("Here the ray leaves surface {}, a {}: t = {}", met.surface->number,
                             word(met.surface->kind), legend_number(roots.t1->value, 6)));
}

void draw_ray(Drawer& drawer, const Story& story, Ink ink, const char* name) {
    if (!is_valid(story.ray)) return;
    const auto& [P, D] = story.ray;
    const Ball& sight = drawer.result.sight;
    const std::vector<MetSurface> met = met_in_order(story);
    double end = (length(P - sight.center) + 8 * sight.radius) / length(D);
    if (!met.empty()) end = std::max(end, 1.05 * met.back().t);
    const double first = met.empty() ? end : met.front().t;
    drawer.line(P, at(story.ray, first), ink, 2);
    if (!met.empty()) drawer.line(at(story.ray, first), at(story.ray, end), ink, 1.5, true);

    drawer.label(P, name, ink, true,
                 fmt::format("{}, where the ray of pixel {}, {} starts: {}", name, story.x, story.y, point_text(P)));
    const PictureInSpace& picture = drawer.result.picture;
    if (picture.t > 0)
        drawer.label(at(story.ray, picture.t), "", ink, true, fmt::format("Pixel {}, {}", story.x, story.y));
    for (std::size_t i = 0; i < met.size(); ++i) {
        const auto& [surface, t] = met[i];
        drawer.label(at(story.ray, t), std::to_string(i + 1), ink, true,
                     fmt::format("Hit {}: surface {}, a {}, at t = {}{}", i + 1, surface->number, word(surface->kind),
                                 legend_number(t, 6), i == 0 ? ", the nearest" : ""));
        draw_exit(drawer, story, met[i], ink);
    }
}

/// "a +", "a −", "a 0".
std::string signed_name(const char* name, double side) {
    return fmt::format("{} {}", name, side > 0 ? "+" : side < 0 ? "−" : side == 0 ? "0" : "?");
}

void draw_sides(Drawer& drawer, const story::TriangleTest& test) {
    const auto& [A, B, C] = test.vertices;
    const double room = 2 * around(Triangle<double>{A, B, C}).radius;
    const auto edge = [&](const Vec3<double>& from, const Vec3<double>& to, Ink ink, const char* name, double side,
                          const char* which) {
        drawer.line(from, to, ink, 2.5);
        drawer.label((from + to) / 2, signed_name(name, side), ink, false,
                     fmt::format("The side product {} with the edge {} is {}", name, which, legend_number(side, 6)),
                     room);
    };
    edge(B, C, Ink::a, "a", test.a.value, "BC");
    edge(C, A, Ink::b, "b", test.b.value, "CA");
    edge(A, B, Ink::c, "c", test.c.value, "AB");
    drawer.label(A, "A", Ink::plain, false, {}, room);
    drawer.label(B, "B", Ink::plain, false, {}, room);
    drawer.label(C, "C", Ink::plain, false, {}, room);
}

void draw_hit(Drawer& drawer, const Story& story) {
    const story::FirstHit& hit = *story.hit;
    const Vec3<double> point = values(hit.point);
    Vec3<double> n = values(hit.normal);
    if (hit.shade) {
        // As shade() turns it.
        if (hit.shade->model != ShadingModel::levental_2014) n = towards(values(hit.shade->r), n);
        drawer.arrow(point, values(hit.shade->l), Ink::light, "l");
        drawer.arrow(point, values(hit.shade->r), Ink::viewer, "r");
        drawer.arrow(point, values(hit.shade->h), Ink::half_vector,
                     hit.shade->model == ShadingModel::phong ? "reflection" : "h");
    }
    drawer.arrow(point, n, Ink::plain, "n");
    for (const story::Surface& surface : story.surfaces)
        if (surface.number == hit.surface)
            if (const auto* test = std::get_if<story::TriangleTest>(&surface.test)) draw_sides(drawer, *test);
}

/// Returns the orbit's distance at which the first hit's surface takes a good part of the pane.
double near_enough_for(const Story& story, const Ball& sight) {
    const auto radius = [](const auto& test) {
        using Test = std::remove_cvref_t<decltype(test)>;
        if constexpr (std::is_same_v<Test, story::SphereTest>) return test.radius;
        else return around(Triangle<double>{test.vertices[0], test.vertices[1], test.vertices[2]}).radius;
    };
    for (const story::Surface& surface : story.surfaces)
        if (surface.number == story.hit->surface)
            return std::clamp(1.5 * std::visit(radius, surface.test) / sight.radius, 5e-3, .5);
    return .2;
}

void place_axes(SpaceDrawing& drawing) {
    const Ball& sight = drawing.sight;
    const std::vector<Tick> lengths = ticks(0, 0.45 * sight.radius, 2, false);
    drawing.axis_length = lengths.empty() || !(lengths.back().value > 0) ? sight.radius / 3 : lengths.back().value;
    if (length(sight.center) > 1.2 * sight.radius)
        drawing.axes_at = sight.center - 0.55 * sight.radius * Vec3<double>{1, 1, 1};
}

}  // namespace

Vec3<double> PictureInSpace::at(double x, double y) const {
    // A pixel's ray goes through its middle.
    return std::visit([&](const auto& v) { return glassbox::at(pixel_ray(v, x - 0.5, height - 0.5 - y), t); }, view);
}

std::optional<Point> PictureInSpace::met_by(const Ray<double>& ray) const {
    const Vec3<double> corner = at(0, height), right = at(width, height) - corner, up = at(0, 0) - corner;
    const Vec3<double> n = cross(right, up);
    const double ray_t = dot(n, corner - ray.P) / dot(n, ray.D);
    if (!(ray_t > 0)) return {};
    const Vec3<double> p = glassbox::at(ray, ray_t) - corner;
    // By Cramer's rule: `right` and `up` need not be at right angles.
    const double u = dot(cross(p, up), n) / dot(n, n), v = dot(cross(right, p), n) / dot(n, n);
    if (!(u >= 0 && u < 1 && v > 0 && v <= 1)) return {};
    return Point{u * width, (1 - v) * height};
}

SurfacesInSpace surfaces_in_space(const Scene& scene, int stage, std::size_t most_spheres, std::size_t most_triangles,
                                  std::size_t sample) {
    Surfaces<double> all = surfaces<double>(scene, stage);
    const std::vector<Rgb> colors = surface_colors(scene);
    SurfacesInSpace result;
    result.all_spheres = all.spheres.size();
    result.all_triangles = all.triangles.size();
    const View unturned = rebuilt_view(scene, {});
    result.upright = upright(unturned);
    find_sight(result, all, {unturned, scene.width, scene.height, starts_at_eye(unturned) ? 1.0 : 0.0});

    const auto every = [](std::size_t count, std::size_t most) { return count / (most + 1) + 1; };
    for (std::size_t i = 0, step = every(all.spheres.size(), most_spheres); i < all.spheres.size(); i += step) {
        result.shown.spheres.push_back(all.spheres[i]);
        result.numbers.push_back(i);
    }
    const auto add = [&](const Triangle<double>& triangle, std::size_t number) {
        result.shown.triangles.push_back(triangle);
        result.numbers.push_back(all.spheres.size() + number);
    };
    std::size_t step = 1;
    if (all.triangles.size() > most_triangles) {
        const std::vector<CoarserTriangle> coarse = coarser(all.triangles, most_triangles);
        result.coarser = coarse.size() >= std::min(sample, most_triangles) / 2;
        if (result.coarser) {
            for (const auto& [triangle, number] : coarse) add(triangle, number);
            result.side = mean_side(result.shown.triangles);
        } else step = every(all.triangles.size(), std::min(sample, most_triangles));
    }
    for (std::size_t i = 0; !result.coarser && i < all.triangles.size(); i += step) add(all.triangles[i], i);
    for (const std::size_t number : result.numbers) result.colors.push_back(colors[number]);
    if (step > 1)
        for (const Mesh& mesh : scene.meshes) {
            Box box;
            for (const Vec3<double>& vertex : mesh.vertices) box.add(vertex);
            if (is_finite(box.least) && is_finite(box.greatest)) result.boxes.push_back({box.least, box.greatest});
        }
    split_triangles(result);
    return result;
}

bool edges_are_seen(const SurfacesInSpace& surfaces, const Camera& camera) {
    constexpr double close = 12;  // pixels
    return !surfaces.coarser || surfaces.side * camera.focal / camera.distance >= close;
}

SpaceDrawing space_drawing(const Scene& scene, const Setup& setup, const SurfacesInSpace& surfaces, const Story* pinned,
                           const Story* compared) {
    Drawer drawer{surfaces, {}};
    SpaceDrawing& result = drawer.result;
    const View seen = view(scene, setup.options);
    result.picture = {seen, scene.width, scene.height, t_of_picture(seen, scene.height, surfaces)};
    result.sight = surfaces.sight;
    for (const Vec3<double>& p : corners(result.picture))
        result.sight.radius = std::max(result.sight.radius, length(p - result.sight.center));
    result.sight.radius = std::max(result.sight.radius, length(standpoint(result.picture) - result.sight.center));
    const bool has_hit = pinned && pinned->hit && is_finite(values(pinned->hit->point));
    result.focus = has_hit ? values(pinned->hit->point) : result.sight.center;
    result.outline = surfaces.outline;
    for (const Vec3<double>& p : corners(result.picture)) result.outline.push_back(p);
    result.outline.push_back(standpoint(result.picture));
    if (has_hit) result.near = near_enough_for(*pinned, result.sight);
    result.light = unit(setup.light_vector);
    result.has_light = setup.options.stage >= 4 && is_finite(result.light);
    place_axes(result);

    draw_view(drawer, !pinned);
    if (compared) draw_ray(drawer, *compared, Ink::second, pinned ? "P₂" : "P");
    if (pinned) {
        draw_ray(drawer, *pinned, Ink::pinned, "P");
        if (pinned->hit) draw_hit(drawer, *pinned);
    }
    return std::move(drawer.result);
}

void Space::update(const ViewerState& state, const Results& results) {
    const Setup& setup = state.setup.now();
    const bool other_surfaces = scene_ != state.scene || stage_ != setup.options.stage;
    if (other_surfaces) {
        scene_ = state.scene;
        stage_ = setup.options.stage;
        surfaces_ = surfaces_in_space(*scene_, stage_);
    }
    if (!other_surfaces && setup_ == setup && pinned_ == results.story && compared_ == results.compared) return;
    setup_ = setup;
    pinned_ = results.story;
    compared_ = results.compared;
    drawing_ = space_drawing(*scene_, setup, surfaces_, pinned_.get(), compared_.get());
}

SeenInSpace seen_at(const Camera& camera, Point screen, const SurfacesInSpace& surfaces, const SpaceDrawing& drawing) {
    const Ray<double> ray = ray_through(camera, screen);
    const Silent silent;
    std::optional<Hit<double>> best;
    std::size_t index = 0;
    for (const auto& sphere : surfaces.shown.spheres)
        best = nearest(best, index++, intersect(ray, sphere, Stable{}, silent));
    for (const auto& triangle : surfaces.shown.triangles)
        best = nearest(best, index++, intersect(ray, triangle, Pluecker{}, silent));
    SeenInSpace seen;
    if (const std::optional<Point> point = drawing.picture.met_by(ray)) {
        const double depth = -dot(drawing.picture.at(point->x, point->y) - ray.P, camera.back);
        if (!best || depth < best->t) {
            seen.on_picture = point;
            return seen;
        }
    }
    if (best && (!surfaces.coarser || best->surface < surfaces.shown.spheres.size()))
        seen.surface = surfaces.numbers[best->surface];
    return seen;
}

}  // namespace glassbox
