// What makes the paper's program faster, one change at a time. Each step says what it changes; all else is as before.
#include "steps.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <crossing.hpp>
#include <intersect_sphere.hpp>
#include <intersect_triangle.hpp>
#include <levental_2014.hpp>
#include <map>
#include <memory>
#include <optional>
#include <probe.hpp>

#include <box.hpp>
#include <slabs.hpp>
#include <tree.hpp>
#include <walk.hpp>

#include "baseline.hpp"

namespace glassbox {

/// baseline.cpp, compiled a second time under this name, without optimisation.
std::vector<unsigned char> render_as_published_unoptimised(int width, int height, double k_a, double k_d, double k_s);

namespace {

using Vector = Vec3<double>;
using Bytes = std::array<unsigned char, 3>;

constexpr Bytes black{0, 0, 0}, red{255, 0, 0}, green{0, 255, 0}, grey{128, 128, 128}, warm{255, 102, 102};
constexpr double k_a = .2, k_d = 1, k_s = .2;
constexpr Vector light{1000, 250, 250}, viewer{1, 0, 0};

/// The paper's shading; the same in all steps, as it is in its program.
Bytes shade(const Vector& n, const Bytes& its_color) {
    const double diffuse = k_d * std::max(0.0, dot(n, unit(light)));
    const double specular = k_s * std::pow(std::max(0.0, dot(n, unit(light + viewer))), 15);
    Bytes color{};
    for (std::size_t c = 0; c < 3; ++c) {
        const int total = static_cast<int>(k_a * warm[c]) + static_cast<int>(diffuse * its_color[c]) +
                          static_cast<int>(specular * 255);
        color[c] = static_cast<unsigned char>(std::min(total, 255));
    }
    return color;
}

/// The picture, by what gives a ray's colour.
template <class Trace>
std::vector<unsigned char> picture(int width, int height, const Trace& trace) {
    std::vector<unsigned char> bytes;
    for (int i = height - 1; i >= 0; --i)
        for (int j = 0; j < width; ++j) {
            const bool border = i == 0 || j == 0 || i == height - 1 || j == width - 1;
            const Bytes traced = trace(Ray<double>{{500, 1.0 * j, 1.0 * i}, {-1, 0, 0}});
            const Bytes color = border ? red : traced;  // traced all the same, as in the paper's program
            bytes.insert(bytes.end(), color.begin(), color.end());
        }
    return bytes;
}

// --- Values: a vector is three numbers, and not a place on the heap where three numbers are. ---

class Surface {
public:
    explicit Surface(Bytes its_color) : color(its_color) {}
    virtual ~Surface() = default;
    virtual double intersection_test(Vector origin, Vector direction) const = 0;
    virtual Vector unit_normal(Vector point) const = 0;

    Bytes color;
};

class PaperSphere final : public Surface {
public:
    PaperSphere(Bytes its_color, Vector its_center, double its_radius)
        : Surface(its_color), center_(its_center), radius_(its_radius) {}

    double intersection_test(Vector origin, Vector direction) const override {
        const Vector v = origin - center_;
        const double v_d = dot(v, direction);
        const double discriminant = v_d * v_d - (dot(v, v) - radius_ * radius_);
        if (!(discriminant > 0)) return -1;
        return -v_d - std::sqrt(discriminant);
    }
    Vector unit_normal(Vector point) const override { return unit(point - center_); }

private:
    Vector center_;
    double radius_;
};

/// A line's Plücker coordinates.
struct Line {
    Vector U, V;
};
Line line(Vector direction, Vector point) { return {direction, cross(direction, point)}; }
double side_product(const Line& i, const Line& j) { return dot(i.U, j.V) + dot(j.U, i.V); }

class PaperTriangle final : public Surface {
public:
    PaperTriangle(Bytes its_color, Vector a, Vector b, Vector c)
        : Surface(its_color), A_(a), B_(b), C_(c), AB_(line(b - a, a)), BC_(line(c - b, b)), CA_(line(a - c, c)) {}

    double intersection_test(Vector origin, Vector direction) const override {
        const Line ray = line(direction, origin);
        const double a = side_product(ray, BC_), b = side_product(ray, CA_), c = side_product(ray, AB_);
        const double all = a + b + c;
        const double off = std::abs(std::abs(all) - (std::abs(a) + std::abs(b) + std::abs(c)));
        if (all == 0 || off >= 10.0) return -1;
        const Vector point = (1 / all) * (a * A_ + b * B_ + c * C_);
        return dot(point - origin, direction);
    }
    Vector unit_normal(Vector) const override { return unit(cross(B_ - A_, C_ - B_)); }

private:
    Vector A_, B_, C_;
    Line AB_, BC_, CA_;
};

constexpr Vector P{200, 350, 100}, Q{200, 400, 100}, R{200, 375, 150}, S{250, 375, 100};

const std::array<PaperSphere, 2>& paper_spheres() {
    static const std::array<PaperSphere, 2> all{PaperSphere(green, {100, 350, 350}, 50),
                                                PaperSphere(red, {50, 300, 300}, 20)};
    return all;
}
const std::array<PaperTriangle, 4>& paper_triangles() {
    static const std::array<PaperTriangle, 4> all{PaperTriangle(grey, P, Q, R), PaperTriangle(grey, P, Q, S),
                                                  PaperTriangle(grey, P, S, R), PaperTriangle(grey, Q, R, S)};
    return all;
}

std::vector<std::unique_ptr<Surface>> surfaces_on_the_heap() {
    std::vector<std::unique_ptr<Surface>> all;
    for (const PaperSphere& one : paper_spheres()) all.push_back(std::make_unique<PaperSphere>(one));
    for (const PaperTriangle& one : paper_triangles()) all.push_back(std::make_unique<PaperTriangle>(one));
    return all;
}

std::vector<unsigned char> with_values(int width, int height) {
    const auto scene = surfaces_on_the_heap();
    return picture(width, height, [&](const Ray<double>& ray) {
        std::map<double, const Surface*> hits;
        for (const auto& one : scene) {
            const double distance = one->intersection_test(ray.P, ray.D);
            if (distance > 0) hits[distance] = one.get();
        }
        if (hits.empty()) return black;
        const auto [distance, nearest] = *hits.begin();
        return shade(nearest->unit_normal(at(ray, distance)), nearest->color);
    });
}

// --- No map: of all hits only the nearest so far is kept. ---

struct Nearest {
    double distance = -1;
    const Surface* surface = nullptr;

    void take(double other, const Surface& its) {
        if (!(other > 0) || (surface && other > distance)) return;
        distance = other;
        surface = &its;
    }
    Bytes color(const Ray<double>& ray) const {
        return surface ? shade(surface->unit_normal(at(ray, distance)), surface->color) : black;
    }
};

std::vector<unsigned char> without_map(int width, int height) {
    const auto scene = surfaces_on_the_heap();
    return picture(width, height, [&](const Ray<double>& ray) {
        Nearest nearest;
        for (const auto& one : scene) nearest.take(one->intersection_test(ray.P, ray.D), *one);
        return nearest.color(ray);
    });
}

// --- No virtual calls: a list of spheres and a list of triangles; the compiler sees the whole loop. ---

std::vector<unsigned char> without_virtual_calls(int width, int height) {
    return picture(width, height, [&](const Ray<double>& ray) {
        Nearest nearest;
        for (const PaperSphere& one : paper_spheres()) nearest.take(one.intersection_test(ray.P, ray.D), one);
        for (const PaperTriangle& one : paper_triangles()) nearest.take(one.intersection_test(ray.P, ray.D), one);
        return nearest.color(ray);
    });
}

// --- As seen from the ray's start: the formulas of lessons 2 and 3. A side product is one dot and one cross product,
// and a triangle's hit point is computed only where it is hit. ---

struct Scene6 {
    std::array<Sphere<double>, 2> spheres{{{{100, 350, 350}, 50}, {{50, 300, 300}, 20}}};
    std::array<Triangle<double>, 4> triangles{{{P, Q, R}, {P, Q, S}, {P, S, R}, {Q, R, S}}};
    std::array<Bytes, 6> colors{green, red, grey, grey, grey, grey};

    Crossing<double> test_sphere(const Ray<double>& ray, std::size_t k) const {
        Silent silent;
        return intersect(ray, spheres[k], Levental2014{}, silent);  // the paper's faults, too: it is the same picture
    }
    Crossing<double> test_triangle(const Ray<double>& ray, std::size_t k) const {
        Silent silent;
        return Pluecker{}(ray, triangles[k], silent);
    }
    Bytes color(const Ray<double>& ray, const std::optional<Hit<double>>& hit) const {
        if (!hit) return black;
        const Vector point = at(ray, hit->t);
        return shade(hit->surface < 2 ? normal(spheres[hit->surface], point) : normal(triangles[hit->surface - 2]),
                     colors[hit->surface]);
    }
    std::optional<Hit<double>> nearest_of_all(const Ray<double>& ray) const {
        std::optional<Hit<double>> best;
        for (std::size_t k = 0; k < 2; ++k) best = nearest(best, k, test_sphere(ray, k));
        for (std::size_t k = 0; k < 4; ++k) best = nearest(best, k + 2, test_triangle(ray, k));
        return best;
    }
    std::vector<engine::Box> boxes() const {
        std::vector<engine::Box> all;
        for (const auto& sphere : spheres) all.push_back(engine::box_of(sphere, {0, 0, 0}));
        for (const auto& triangle : triangles) all.push_back(engine::box_of(triangle, {0, 0, 0}));
        return all;
    }
};

std::vector<unsigned char> from_the_start(int width, int height) {
    const Scene6 scene;
    return picture(width, height, [&](const Ray<double>& ray) { return scene.color(ray, scene.nearest_of_all(ray)); });
}

// --- Empty space: most rays meet nothing, says the paper. A box around all tells of most of these at once. ---

std::vector<unsigned char> with_one_box(int width, int height) {
    const Scene6 scene;
    engine::Box all;
    for (const engine::Box& one : scene.boxes()) all.add(one);
    return picture(width, height, [&](const Ray<double>& ray) {
        if (is_empty(engine::through(all, ray.P, engine::inverse(ray.D)))) return black;
        return scene.color(ray, scene.nearest_of_all(ray));
    });
}

// --- The tree: boxes in boxes. ---

std::vector<unsigned char> with_a_tree(int width, int height) {
    const Scene6 scene;
    const engine::Tree tree = engine::tree_over(scene.boxes());
    Silent silent;
    return picture(width, height, [&](const Ray<double>& ray) {
        const auto test = [&](std::size_t k) {
            return k < 2 ? scene.test_sphere(ray, k) : scene.test_triangle(ray, k - 2);
        };
        return scene.color(ray, engine::walk(tree, ray, test, silent));
    });
}

}  // namespace

std::vector<Step> steps_of_speed() {
    return {{"the paper's program, not optimised",
             [](int w, int h) { return render_as_published_unoptimised(w, h, k_a, k_d, k_s); }},
            {"optimised by the compiler", [](int w, int h) { return render_as_published(w, h, k_a, k_d, k_s); }},
            {"vectors are values", with_values},
            {"no map of hits", without_map},
            {"no virtual calls", without_virtual_calls},
            {"seen from the ray's start", from_the_start},
            {"one box around all", with_one_box},
            {"a tree of boxes", with_a_tree}};
}

}  // namespace glassbox
