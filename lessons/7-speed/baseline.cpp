// A ray tracer as "Ray Tracer" (Levental 2014) describes its own in section 2, written anew from that description. It
// is here to be measured, so it keeps what makes that program slow: vectors on the heap, handed over by value; a
// virtual call for each surface and ray; a map of all hits to find one; every pixel against every surface; one thread.
//
// It keeps that program's formulas too, in their order, and with their faults: a sphere is hit where the discriminant
// is above 0, so not where a ray only touches it, and only at the nearer root; Plücker coordinates in the world's
// frame, the tolerance of 10; three terms cut to whole bytes. One fault is mended, or no picture could be compared:
// each side product weights the vertex opposite to its edge.
#include "baseline.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <memory>
#include <vector>

namespace glassbox {
namespace {

using vector = std::vector<double>;
using rgb = std::array<unsigned char, 3>;

vector sum(vector a, vector b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }
vector difference(vector a, vector b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
vector scaled(double s, vector a) { return {s * a[0], s * a[1], s * a[2]}; }
double inner_product(vector a, vector b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
vector cross_product(vector a, vector b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
vector unit_vector(vector a) {
    const double norm = std::sqrt(inner_product(a, a));
    return {a[0] / norm, a[1] / norm, a[2] / norm};
}

const double none = -1;
const double tolerance = 10.0;
const double illumination = 1;
const double exponent = 15;
const vector light = {1000, 250, 250};
const vector viewer = {1, 0, 0};
const rgb warm = {255, 102, 102};
const rgb red = {255, 0, 0};

class surface {
public:
    explicit surface(rgb its_color) : color(its_color) {}
    virtual ~surface() = default;

    /// The distance from the viewing plane; what is not above 0, such as -1, is none.
    virtual double intersection_test(vector origin, vector direction) const = 0;
    virtual vector unit_normal(vector point) const = 0;

    const rgb color;
};

class sphere : public surface {
public:
    sphere(rgb its_color, vector its_center, double its_radius)
        : surface(its_color), center(its_center), radius(its_radius) {}

    double intersection_test(vector origin, vector direction) const override {
        const vector v = difference(origin, center);
        const double v_d = inner_product(v, direction);
        const double discriminant = v_d * v_d - (inner_product(v, v) - radius * radius);
        if (!(discriminant > 0)) return none;
        return std::min(-v_d - std::sqrt(discriminant), -v_d + std::sqrt(discriminant));
    }

    vector unit_normal(vector point) const override { return unit_vector(difference(point, center)); }

private:
    vector center;
    double radius;
};

/// A line's Plücker coordinates (U, V), from a point on it and its direction U.
struct line {
    vector U, V;
    line(vector direction, vector point) : U(direction), V(cross_product(direction, point)) {}
};

double side_product(line i, line j) { return inner_product(i.U, j.V) + inner_product(j.U, i.V); }

class triangle : public surface {
public:
    triangle(rgb its_color, vector a, vector b, vector c)
        : surface(its_color),
          A(a),
          B(b),
          C(c),
          AB(difference(b, a), a),
          BC(difference(c, b), b),
          CA(difference(a, c), c) {}

    double intersection_test(vector origin, vector direction) const override {
        const line ray(direction, origin);
        const double a = side_product(ray, BC);
        const double b = side_product(ray, CA);
        const double c = side_product(ray, AB);
        const double all = a + b + c;
        const double diff = std::abs(std::abs(all) - (std::abs(a) + std::abs(b) + std::abs(c)));
        if (all == 0 || diff >= tolerance) return none;
        const vector weighted = sum(sum(scaled(a, A), scaled(b, B)), scaled(c, C));
        const vector point = scaled(1 / all, weighted);
        return inner_product(difference(point, origin), direction);
    }

    vector unit_normal(vector) const override { return unit_vector(cross_product(difference(B, A), difference(C, B))); }

private:
    vector A, B, C;
    line AB, BC, CA;
};

using surfaces = std::vector<std::unique_ptr<surface>>;

surfaces the_papers_scene() {
    const rgb green = {0, 255, 0}, grey = {128, 128, 128};
    const vector P = {200, 350, 100}, Q = {200, 400, 100}, R = {200, 375, 150}, S = {250, 375, 100};
    surfaces scene;
    scene.push_back(std::make_unique<sphere>(green, vector{100, 350, 350}, 50));
    scene.push_back(std::make_unique<sphere>(red, vector{50, 300, 300}, 20));
    scene.push_back(std::make_unique<triangle>(grey, P, Q, R));
    scene.push_back(std::make_unique<triangle>(grey, P, Q, S));
    scene.push_back(std::make_unique<triangle>(grey, P, S, R));
    scene.push_back(std::make_unique<triangle>(grey, Q, R, S));
    return scene;
}

struct factors {
    double k_a, k_d, k_s;
};

rgb shade(const surface& nearest, vector point, factors k) {
    const vector normal = nearest.unit_normal(point);
    const vector bisector = unit_vector(sum(light, viewer));  // sic: the light's vector is not of length 1
    const double diffuse = illumination * (k.k_d * std::max(0.0, inner_product(normal, unit_vector(light))));
    const double specular = illumination * (k.k_s * std::pow(std::max(0.0, inner_product(normal, bisector)), exponent));
    rgb color{};
    for (std::size_t channel = 0; channel < 3; ++channel) {
        const int total = static_cast<int>(illumination * k.k_a * warm[channel]) +
                          static_cast<int>(diffuse * nearest.color[channel]) + static_cast<int>(specular * 255);
        color[channel] = static_cast<unsigned char>(std::min(total, 255));
    }
    return color;
}

rgb trace(const surfaces& scene, vector origin, vector direction, factors k) {
    std::map<double, const surface*> hits;
    for (const auto& each : scene) {
        const double distance = each->intersection_test(origin, direction);
        if (distance > 0) hits[distance] = each.get();
    }
    if (hits.empty()) return {0, 0, 0};
    const auto [distance, nearest] = *hits.begin();
    return shade(*nearest, sum(origin, scaled(distance, direction)), k);
}

}  // namespace

std::vector<unsigned char> render_as_published(int width, int height, double k_a, double k_d, double k_s) {
    const surfaces scene = the_papers_scene();
    const vector direction = {-1, 0, 0};
    std::vector<unsigned char> picture;
    for (int i = height - 1; i >= 0; --i) {
        for (int j = 0; j < width; ++j) {
            const vector origin = {500, static_cast<double>(j), static_cast<double>(i)};
            rgb color = trace(scene, origin, direction, {k_a, k_d, k_s});
            if (i == 0 || j == 0 || i == height - 1 || j == width - 1) color = red;
            picture.insert(picture.end(), color.begin(), color.end());
        }
    }
    return picture;
}

std::int64_t rays_as_published(int width, int height) { return std::int64_t{width} * height; }

}  // namespace glassbox
