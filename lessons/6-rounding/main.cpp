// Lesson 6: what a sign is worth. A tetrahedron from three distances, left to right; and in each row another judge of
// its side products: plain double, the filter's bound found once for all rays, and bounds that run along with each ray.
// All coordinates are whole numbers, so that the truth can be computed without rounding.
#include <array>
#include <picture.hpp>
#include <sides.hpp>

#include <bounded.hpp>
#include <filter.hpp>

using namespace glassbox;

namespace {

__extension__ typedef __int128 Whole;

constexpr int size = 160;                                  // of one picture
constexpr std::array<double, 3> distances{1e8, 1e9, 3e9};  // from the tetrahedron to the viewing plane, in lengths of D

// Three directions at right angles to each other and all of length 7, in whole numbers.
constexpr Vec3<double> right{3, -6, 2}, up{6, 2, -3}, forth{2, 3, 6};

/// A point by its steps to the right, upwards and towards the viewer.
Vec3<double> at(double x, double y, double z) { return x * right + y * up + z * forth; }

/// Plain double: the sign that the number has.
Kleene is_negative(double s) { return s < 0; }
Kleene is_positive(double s) { return s > 0; }
Kleene is_negative(const Bounded& s) { return s < Bounded(0); }
Kleene is_positive(const Bounded& s) { return s > Bounded(0); }

/// The side products' verdict, or "undecided", from the signs alone.
template <class Real>
Kleene is_hit(const Sides<Real>& s) {
    const Kleene none_negative = !is_negative(s.a) && !is_negative(s.b) && !is_negative(s.c);
    const Kleene none_positive = !is_positive(s.a) && !is_positive(s.b) && !is_positive(s.c);
    return none_negative != none_positive;  // both hold where all three are 0
}

Kleene by_double(const Ray<double>& ray, const Triangle<double>& triangle) {
    return is_hit(sides(ray.D, seen_from(ray.P, triangle)));
}

/// As plain double, and sure of it where each product is farther from 0 than the bound found for all rays.
Kleene by_filter(const Ray<double>& ray, const Triangle<double>& triangle, double error) {
    const auto [a, b, c] = sides(ray.D, seen_from(ray.P, triangle));
    return is_hit(Sides<Bounded>{{a, error}, {b, error}, {c, error}});
}

/// The same formula in Bounded.
Kleene by_running_bounds(const Ray<double>& ray, const Triangle<double>& triangle) {
    return is_hit(sides(convert<Bounded>(ray.D), seen_from(convert<Bounded>(ray.P), convert<Bounded>(triangle))));
}

/// The same formula in whole numbers.
bool truly(const Ray<double>& ray, const Triangle<double>& triangle) {
    const auto [a, b, c] = sides(convert<Whole>(ray.D), seen_from(convert<Whole>(ray.P), convert<Whole>(triangle)));
    return (a >= 0 && b >= 0 && c >= 0) != (a <= 0 && b <= 0 && c <= 0);
}

/// Hit if one triangle surely is, miss if all surely are missed.
Kleene either(Kleene a, Kleene b) { return !(!a && !b); }

Vec3<int> color(Kleene answer, bool truth) {
    if (surely(answer) != truth && surely(answer) == possibly(answer)) return {230, 0, 50};  // sure, and wrong
    if (surely(answer)) return {170, 170, 170};
    return possibly(answer) ? Vec3<int>{255, 210, 0} : Vec3<int>{20, 30, 70};
}

}  // namespace

int main(int argc, char** argv) {
    const Vec3<double> P = at(-119, -101, 1), Q = at(121, -99, -1), R = at(1, 119, 3), S = at(3, -31, 101);
    const std::array<Triangle<double>, 4> triangles{{{P, Q, R}, {P, Q, S}, {P, S, R}, {Q, R, S}}};

    Picture picture(3 * size, 3 * size);
    for (int column = 0; column < 3; ++column) {
        const auto ray = [&](int j, int i) {
            return Ray<double>{at(2 * j - size, 2 * i - size, distances[static_cast<std::size_t>(column)]), -forth};
        };
        RayBounds reach;
        for (const int j : {0, size - 1})
            for (const int i : {0, size - 1}) reach = including(reach, ray(j, i));
        std::array<double, 4> errors{};
        for (std::size_t k = 0; k < 4; ++k) errors[k] = filter::sides_error(triangles[k], reach);

        for (int i = 0; i < size; ++i) {
            for (int j = 0; j < size; ++j) {
                bool truth = false;
                Kleene plain = false, filtered = false, bounded = false;
                for (std::size_t k = 0; k < 4; ++k) {
                    truth = truth || truly(ray(j, i), triangles[k]);
                    plain = either(plain, by_double(ray(j, i), triangles[k]));
                    filtered = either(filtered, by_filter(ray(j, i), triangles[k], errors[k]));
                    bounded = either(bounded, by_running_bounds(ray(j, i), triangles[k]));
                }
                picture.paint(column * size + j, 2 * size + i, color(plain, truth));
                picture.paint(column * size + j, size + i, color(filtered, truth));
                picture.paint(column * size + j, i, color(bounded, truth));
            }
        }
    }
    return picture.write(argc > 1 ? argv[1] : "rounding.ppm");
}
