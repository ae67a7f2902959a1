#pragma once
#include <ray.hpp>

#include <algorithm>
#include <array>
#include <bit>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <initializer_list>
#include <limits>
#include <optional>
#include <vector>

#include "scene/scene.hpp"

/// What a ray truly meets, found independently of the core: in whole numbers, never rounded, and by other formulas.
///
/// All coordinates of a scene and a ray's start are multiples of one power of two, and a direction's of another; in
/// those units they are whole numbers.
namespace glassbox::oracle {

namespace mp = boost::multiprecision;

using Whole =
    mp::number<mp::cpp_int_backend<512, 0, mp::signed_magnitude, mp::unchecked, std::allocator<mp::limb_type>>,
               mp::et_off>;
/// For telling sizes: 256 bits, and exponents that neither overflow nor underflow.
using Long = mp::number<mp::cpp_bin_float<256, mp::digit_base_2, void, std::int64_t>, mp::et_off>;

struct Vector {
    Whole x, y, z;

    friend Vector operator-(const Vector& a, const Vector& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
};

inline Whole dot(const Vector& a, const Vector& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

/// The determinant of the matrix with columns a, b and c.
inline Whole det(const Vector& a, const Vector& b, const Vector& c) {
    return a.x * (b.y * c.z - b.z * c.y) - b.x * (a.y * c.z - a.z * c.y) + c.x * (a.y * b.z - a.z * b.y);
}

/// The exponent of the last bit of a double; of 0, a large one.
inline int last_bit(double x) {
    if (x == 0) return 4096;
    int exponent = 0;
    const auto bits = static_cast<std::uint64_t>(std::ldexp(std::abs(std::frexp(x, &exponent)), 53));
    return exponent - 53 + std::countr_zero(bits);
}

inline int last_bit(const Vec3<double>& v) { return std::min({last_bit(v.x), last_bit(v.y), last_bit(v.z)}); }

/// x in units of 2^unit, which must not be larger than its last bit.
inline Whole whole(double x, int unit) {
    if (x == 0) return 0;
    const int exponent = last_bit(x);
    return Whole(static_cast<long long>(std::ldexp(x, -exponent))) << static_cast<unsigned>(exponent - unit);
}

inline Vector whole(const Vec3<double>& v, int unit) { return {whole(v.x, unit), whole(v.y, unit), whole(v.z, unit)}; }

/// A distance along the ray: (n + s√d) / m · 2^exponent, with m > 0, d ≥ 0 and s = −1, 0 or 1.
struct Distance {
    Whole n, m = 1, d;
    int s = 0;
    long exponent = 0;
    Long size;  ///< the same, to 250 bits or more
};

/// The sign of a + b√d.
inline int sign(const Whole& a, const Whole& b, const Whole& d) {
    const int of_a = a.sign(), of_b = d.is_zero() ? 0 : b.sign();
    if (of_a * of_b >= 0) return of_a + of_b > 0 ? 1 : of_a + of_b < 0 ? -1 : 0;
    return of_a * Whole(a * a - b * b * d).sign();
}

/// The sign of a + b√d + c√e.
inline int sign(const Whole& a, const Whole& b, const Whole& d, const Whole& c, const Whole& e) {
    const int left = sign(a, b, d), right = e.is_zero() ? 0 : c.sign();
    if (left * right >= 0) return left != 0 ? left : right;
    return left * sign(a * a + b * b * d - c * c * e, 2 * a * b, d);
}

/// The sign of a − b. Both belong to one ray, or to none: their exponents may differ.
inline int compare(const Distance& a, const Distance& b) {
    const Long gap = a.size - b.size;
    if (abs(gap) > ldexp(abs(a.size) + abs(b.size), -240)) return gap < 0 ? -1 : 1;
    const auto low = std::min(a.exponent, b.exponent);
    const Whole by_a = b.m << static_cast<unsigned long>(a.exponent - low);
    const Whole by_b = a.m << static_cast<unsigned long>(b.exponent - low);
    return sign(a.n * by_a - b.n * by_b, a.s * by_a, a.d, -b.s * by_b, b.d);
}

/// The sum of some doubles as a distance.
inline Distance sum(std::initializer_list<double> terms) {
    int unit = 0;
    for (const double term : terms) unit = std::min(unit, last_bit(term));
    Distance result;
    for (const double term : terms) result.n += whole(term, unit);
    result.exponent = unit;
    result.size = ldexp(Long(result.n), unit);
    return result;
}

/// A surface that the ray meets, and where.
struct Meeting {
    std::size_t surface;
    Distance t;
};

/// All surfaces that a ray meets at t > 0.
struct Answer {
    bool valid = false;
    std::vector<Meeting> met;
    std::optional<Meeting> first;  ///< the nearest; of those at one distance the one listed last
};

class Oracle {
public:
    explicit Oracle(const Scene& scene) {
        for (const ColoredSphere& sphere : scene.spheres) add(sphere.center, sphere.radius);
        for (const ColoredTriangle& triangle : scene.triangles) add(triangle.vertices);
        for (const Mesh& mesh : scene.meshes)
            for (const auto& face : mesh.faces)
                add({mesh.vertices[face[0]], mesh.vertices[face[1]], mesh.vertices[face[2]]});
    }

    Answer operator()(const Ray<double>& ray) const {
        Answer answer;
        answer.valid = is_number(ray.P) && is_number(ray.D) && (ray.D.x != 0 || ray.D.y != 0 || ray.D.z != 0);
        if (!answer.valid) return answer;
        const auto consider = [&](std::size_t surface, std::optional<Distance> t) {
            if (!t) return;
            answer.met.push_back({surface, std::move(*t)});
            const Meeting& meeting = answer.met.back();
            if (!answer.first || compare(meeting.t, answer.first->t) <= 0) answer.first = meeting;
        };
        std::size_t surface = 0;
        for (const Sphere& sphere : spheres_) {
            if (may_meet(sphere.around, ray)) consider(surface, t_of(sphere, ray));
            ++surface;
        }
        for (const Triangle& triangle : triangles_) {
            if (may_meet(triangle.around, ray)) consider(surface, t_of(triangle, ray));
            ++surface;
        }
        return answer;
    }

private:
    /// Some surface lies within `reach` of `middle`.
    struct Ball {
        std::array<long double, 3> middle;
        long double reach;
    };

    struct Sphere {
        Vec3<double> c;
        double r;
        Ball around;
    };

    struct Triangle {
        std::array<Vec3<double>, 3> at;
        Ball around;
    };

    static bool is_number(const Vec3<double>& v) {
        return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
    }

    void add(const Vec3<double>& c, double r) { spheres_.push_back({c, r, {{c.x, c.y, c.z}, r}}); }

    void add(const std::array<Vec3<double>, 3>& at) {
        const auto mean = [](long double a, long double b, long double c) { return a / 3 + b / 3 + c / 3; };
        const std::array middle{mean(at[0].x, at[1].x, at[2].x), mean(at[0].y, at[1].y, at[2].y),
                                mean(at[0].z, at[1].z, at[2].z)};
        long double reach = 0;
        for (const Vec3<double>& v : at)
            reach = std::max(reach, std::hypot(v.x - middle[0], v.y - middle[1], v.z - middle[2]));
        triangles_.push_back({at, {middle, reach}});
    }

    /// False only if the ray's line passes the ball by far: by 10⁻⁹ of all coordinates, where rounding matters to
    /// less than 10⁻¹⁵ of them. Should anything overflow, it answers true.
    static bool may_meet(const Ball& ball, const Ray<double>& ray) {
        const auto& [x, y, z] = ball.middle;
        const long double dx = ray.D.x, dy = ray.D.y, dz = ray.D.z;
        const long double px = x - ray.P.x, py = y - ray.P.y, pz = z - ray.P.z;
        const long double cx = py * dz - pz * dy, cy = pz * dx - px * dz, cz = px * dy - py * dx;
        const auto size = [](long double a, long double b, long double c) {
            return std::abs(a) + std::abs(b) + std::abs(c);
        };
        const long double margin = 1e-9L * (size(x, y, z) + size(ray.P.x, ray.P.y, ray.P.z));
        const long double far = ball.reach * 1.000001L + margin;
        return !(cx * cx + cy * cy + cz * cz > far * far * (dx * dx + dy * dy + dz * dz) * 1.000001L);
    }

    /// P + tD = A + u(B − A) + v(C − A), by Cramer's rule: inside where u, v ≥ 0 and u + v ≤ 1.
    static std::optional<Distance> t_of(const Triangle& triangle, const Ray<double>& ray) {
        const auto& corner = triangle.at;
        const int unit = std::min({last_bit(corner[0]), last_bit(corner[1]), last_bit(corner[2]), last_bit(ray.P)});
        const int unit_of_D = last_bit(ray.D);
        const Vector A = whole(corner[0], unit), E = whole(corner[1], unit) - A, F = whole(corner[2], unit) - A;
        const Vector D = whole(ray.D, unit_of_D), T = whole(ray.P, unit) - A;
        // T = uE + vF − tD
        Whole all = det(E, F, D), u = det(T, F, D), v = det(E, T, D), t = -det(E, F, T);
        if (all.is_zero()) return {};  // edge-on, or without area
        if (all.sign() < 0) {
            all = -all;
            u = -u;
            v = -v;
            t = -t;
        }
        if (u.sign() < 0 || v.sign() < 0 || u + v > all || t.sign() <= 0) return {};
        const long exponent = unit - unit_of_D;
        const Long size = ldexp(Long(t) / Long(all), exponent);
        return Distance{t, all, 0, 0, exponent, size};
    }

    /// With f = P − c: (D·D) t² + 2 (f·D) t + f·f − r² = 0. Which root counts follows from the coefficients' signs.
    static std::optional<Distance> t_of(const Sphere& sphere, const Ray<double>& ray) {
        const int unit = std::min({last_bit(sphere.c), last_bit(sphere.r), last_bit(ray.P)});
        const int unit_of_D = last_bit(ray.D);
        const Vector D = whole(ray.D, unit_of_D), f = whole(ray.P, unit) - whole(sphere.c, unit);
        const Whole r = whole(sphere.r, unit);
        const Whole a = dot(D, D), b = dot(f, D), c = dot(f, f) - r * r;
        const Whole quarter = b * b - a * c;  // of the discriminant
        if (quarter.sign() < 0) return {};
        const bool starts_inside = c.sign() < 0;
        if (!starts_inside && b.sign() >= 0) return {};  // no root, or none ahead
        // From inside, or from the surface inwards, the larger root; from outside the smaller one. −b ∓ √ where this
        // adds two numbers of one sign, else what the other root leaves of their product c/a.
        const int s = c.sign() > 0 ? -1 : 1;
        const long exponent = unit - unit_of_D;
        const Long root = sqrt(Long(quarter)), minus_b(-b);
        const Long size = b.sign() < 0 && s > 0 ? (minus_b + root) / Long(a)
                          : b.sign() < 0        ? Long(c) / (minus_b + root)
                                                : Long(-c) / (root - minus_b);
        return Distance{-b, a, quarter, s, exponent, ldexp(size, exponent)};
    }

    std::vector<Sphere> spheres_;
    std::vector<Triangle> triangles_;
};

}  // namespace glassbox::oracle
