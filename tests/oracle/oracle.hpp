#pragma once
#include <cstddef>
#include <optional>
#include <string>
#include <variant>
#include <vector>

/// What a ray truly meets. It uses nothing of the program, neither a header nor a formula nor a number, so that the two
/// can be compared.
///
/// Doubles are integers times powers of two, and integer arithmetic rounds nothing. Most surfaces are decided earlier,
/// in long double with a bound on the error. Its range is so large that no product of seven doubles leaves it; where a
/// compiler has no such type, everything is decided in integers.
namespace oracle {

struct Point {
    double x = 0, y = 0, z = 0;
};

/// P + tD, t > 0.
struct Ray {
    Point P, D;
};

struct Sphere {
    Point c;
    double r = 0;
};

struct Triangle {
    Point A, B, C;
};

/// Numbered from 0: the spheres first.
struct Surfaces {
    std::vector<Sphere> spheres;
    std::vector<Triangle> triangles;

    std::size_t size() const { return spheres.size() + triangles.size(); }
};

/// When a triangle is met. Without a tolerance, where the ray goes through a point of it, edges and vertices included,
/// and does not lie in its plane. With one, where the ray crosses its plane, and of the three weights of that point, as
/// determinants of vertices and direction, those of the rarer sign add up to less than half of the tolerance.
struct Rule {
    std::optional<double> tolerance = {};
};

/// A surface that the ray meets, and two numbers that its t lies between.
struct Meeting {
    std::size_t surface;
    long double low, high;
};

struct Answer {
    bool valid = false;  ///< the ray's numbers are finite, and D is not 0
    std::vector<Meeting> met;
    std::optional<Meeting> first;  ///< the nearest; of those at one distance the one listed last
};

/// A unit normal, off by no more than 2⁻⁵⁰ times `condition`, which is that of the textbook formulas, and infinite
/// where all digits cancel.
struct Normal {
    Point n;
    double condition;
};

class Oracle {
public:
    explicit Oracle(Surfaces surfaces, Rule rule = {});

    Answer operator()(const Ray& ray) const;

    /// The sign of one t minus the other, for meetings of one ray.
    int compare(const Ray& ray, const Meeting& one, const Meeting& other) const;
    /// The sign of t minus the sum of some doubles.
    int compare(const Ray& ray, const Meeting& meeting, std::initializer_list<double> sum) const;
    /// Whether |t − the true t| ≤ error.
    bool is_within(const Ray& ray, const Meeting& meeting, long double t, double error) const;
    /// |t − the true t|, to a dozen digits.
    long double error_of(const Ray& ray, const Meeting& meeting, long double t) const;
    /// The true t, to `digits` digits.
    std::string t_text(const Ray& ray, const Meeting& meeting, int digits) const;

    /// (B − A) × (C − A) made unit, or from a sphere's centre to where it is met.
    Normal normal(const Ray& ray, const Meeting& meeting) const;

    const Surfaces& surfaces() const { return surfaces_; }

private:
    /// (x, y, z) and the sizes that the errors of x, y and z are in proportion to.
    struct Rounded {
        long double x, y, z, size_x, size_y, size_z;
    };
    /// A triangle's edges from A, and its normal.
    struct Edges {
        Rounded E, F, N;
    };

    std::optional<Meeting> meet(std::size_t surface, const Ray& ray) const;
    std::optional<Meeting> meet_sphere(std::size_t surface, const Ray& ray) const;
    std::optional<Meeting> meet_triangle(std::size_t surface, const Ray& ray) const;
    std::optional<Meeting> meet_exactly(std::size_t surface, const Ray& ray) const;

    Surfaces surfaces_;
    Rule rule_;
    std::vector<Edges> edges_;
};

/// Rays that start in corner + j·right + i·up and run along `direction`; j counts from the left, i from the bottom.
struct Parallel {
    Point corner, right, up, direction;
};

/// Rays from the eye through the middles of square pixels on a plane at distance 1; the angle from its lower to its
/// upper edge is given in degrees.
struct Pinhole {
    Point eye, look_at, up;
    double field_of_view = 45;
};

using View = std::variant<Parallel, Pinhole>;

/// How far a pixel's ray is from where it should be, in units of what rounding may move it by; above 1 it is wrong.
/// The pixel is in column j and row i of a picture of width × height.
double ray_error(const View& view, int width, int height, int j, int i, const Ray& ray);

}  // namespace oracle
