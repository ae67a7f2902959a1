#include "oracle/oracle.hpp"

#include <algorithm>
#include <bit>
#include <boost/math/constants/constants.hpp>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

namespace oracle {

namespace {

namespace mp = boost::multiprecision;

using Whole =
    mp::number<mp::cpp_int_backend<512, 0, mp::signed_magnitude, mp::unchecked, std::allocator<mp::limb_type>>,
               mp::et_off>;
/// For comparing sizes: 256 bits, and exponents that neither overflow nor underflow.
using Long = mp::number<mp::cpp_bin_float<256, mp::digit_base_2, void, std::int64_t>, mp::et_off>;

// Integers

struct Vector {
    Whole x, y, z;

    friend Vector operator-(const Vector& a, const Vector& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
};

Whole dot(const Vector& a, const Vector& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

/// The determinant of the matrix with columns a, b and c.
Whole det(const Vector& a, const Vector& b, const Vector& c) {
    return a.x * (b.y * c.z - b.z * c.y) - b.x * (a.y * c.z - a.z * c.y) + c.x * (a.y * b.z - a.z * b.y);
}

/// The exponent of the last bit of a double; of 0, a large one.
int last_bit(double x) {
    if (x == 0) return 4096;
    int exponent = 0;
    const auto bits = static_cast<std::uint64_t>(std::ldexp(std::abs(std::frexp(x, &exponent)), 53));
    return exponent - 53 + std::countr_zero(bits);
}

int last_bit(const Point& v) { return std::min({last_bit(v.x), last_bit(v.y), last_bit(v.z)}); }

/// x in units of 2^unit, which must not be larger than its last bit.
Whole whole(double x, int unit) {
    if (x == 0) return 0;
    const int exponent = last_bit(x);
    return Whole(static_cast<long long>(std::ldexp(x, -exponent))) << static_cast<unsigned>(exponent - unit);
}

Vector whole(const Point& v, int unit) { return {whole(v.x, unit), whole(v.y, unit), whole(v.z, unit)}; }

/// The sign of a + b√d.
int sign(const Whole& a, const Whole& b, const Whole& d) {
    const int of_a = a.sign(), of_b = d.is_zero() ? 0 : b.sign();
    if (of_a * of_b >= 0) return of_a + of_b > 0 ? 1 : of_a + of_b < 0 ? -1 : 0;
    return of_a * Whole(a * a - b * b * d).sign();
}

/// The sign of a + b√d + c√e.
int sign(const Whole& a, const Whole& b, const Whole& d, const Whole& c, const Whole& e) {
    const int left = sign(a, b, d), right = e.is_zero() ? 0 : c.sign();
    if (left * right >= 0) return left != 0 ? left : right;
    return left * sign(a * a + b * b * d - c * c * e, 2 * a * b, d);
}

/// A distance along a ray: (n + s√d) / m · 2^exponent, with m > 0, d ≥ 0 and s = −1, 0 or 1.
struct Distance {
    Whole n, m = 1, d;
    int s = 0;
    long exponent = 0;
    Long size;  ///< the same, to 240 bits or more
};

int compare(const Distance& a, const Distance& b) {
    const Long gap = a.size - b.size;
    if (abs(gap) > ldexp(abs(a.size) + abs(b.size), -240)) return gap < 0 ? -1 : 1;
    const auto low = std::min(a.exponent, b.exponent);
    const Whole by_a = b.m << static_cast<unsigned long>(a.exponent - low);
    const Whole by_b = a.m << static_cast<unsigned long>(b.exponent - low);
    return sign(a.n * by_a - b.n * by_b, a.s * by_a, a.d, -b.s * by_b, b.d);
}

Distance sum_of(std::initializer_list<double> terms) {
    int unit = 0;
    for (const double term : terms) unit = std::min(unit, last_bit(term));
    Distance result;
    for (const double term : terms) result.n += whole(term, unit);
    result.exponent = unit;
    result.size = ldexp(Long(result.n), unit);
    return result;
}

/// P + tD = A + u(B − A) + v(C − A), by Cramer's rule: inside where u, v ≥ 0 and u + v ≤ 1.
std::optional<Distance> t_of(const Triangle& triangle, const Rule& rule, const Ray& ray) {
    const int unit = std::min({last_bit(triangle.A), last_bit(triangle.B), last_bit(triangle.C), last_bit(ray.P)});
    const int unit_of_D = last_bit(ray.D);
    const Vector A = whole(triangle.A, unit), E = whole(triangle.B, unit) - A, F = whole(triangle.C, unit) - A;
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
    if (t.sign() <= 0) return {};
    const Whole rest = all - u - v;
    if (u.sign() < 0 || v.sign() < 0 || rest.sign() < 0) {
        if (!rule.tolerance) return {};
        Whole rarer = 0;  // as all > 0, the negative ones
        for (const Whole& weight : {u, v, rest})
            if (weight.sign() < 0) rarer -= weight;
        const int of_weights = 2 * unit + unit_of_D, of_tolerance = last_bit(*rule.tolerance);
        const int least = std::min(of_weights, of_tolerance);
        if ((2 * rarer) << static_cast<unsigned>(of_weights - least) >= whole(*rule.tolerance, least)) return {};
    } else if (rule.tolerance && !(*rule.tolerance > 0)) {
        return {};  // 0 is not less than it
    }
    const long exponent = unit - unit_of_D;
    const Long size = ldexp(Long(t) / Long(all), exponent);
    return Distance{t, all, 0, 0, exponent, size};
}

/// With f = P − c: (D·D) t² + 2 (f·D) t + f·f − r² = 0. Which root counts follows from the coefficients' signs.
std::optional<Distance> t_of(const Sphere& sphere, const Ray& ray) {
    const int unit = std::min({last_bit(sphere.c), last_bit(sphere.r), last_bit(ray.P)});
    const int unit_of_D = last_bit(ray.D);
    const Vector D = whole(ray.D, unit_of_D), f = whole(ray.P, unit) - whole(sphere.c, unit);
    const Whole r = whole(sphere.r, unit);
    const Whole a = dot(D, D), b = dot(f, D), c = dot(f, f) - r * r;
    const Whole quarter = b * b - a * c;  // of the discriminant
    if (quarter.sign() < 0) return {};
    const bool starts_inside = c.sign() < 0;
    if (!starts_inside && b.sign() >= 0) return {};  // no root, or none ahead
    // From inside, or from the surface inwards, the larger root; from outside the smaller one. Computes −b ∓ √ where
    // this adds two numbers of one sign, else divides the roots' product c/a by the other root.
    const int s = c.sign() > 0 ? -1 : 1;
    const long exponent = unit - unit_of_D;
    const Long root = sqrt(Long(quarter)), minus_b(-b);
    const Long size = b.sign() < 0 && s > 0 ? (minus_b + root) / Long(a)
                      : b.sign() < 0        ? Long(c) / (minus_b + root)
                                            : Long(-c) / (root - minus_b);
    return Distance{-b, a, quarter, s, exponent, ldexp(size, exponent)};
}

std::optional<Distance> t_of(const Surfaces& surfaces, const Rule& rule, std::size_t surface, const Ray& ray) {
    const std::size_t spheres = surfaces.spheres.size();
    return surface < spheres ? t_of(surfaces.spheres[surface], ray)
                             : t_of(surfaces.triangles[surface - spheres], rule, ray);
}

// Long double

/// Half of an ulp of 1.
constexpr long double u = std::numeric_limits<long double>::epsilon() / 2;
/// Whether products of seven doubles and sums of these neither overflow nor underflow, and lose no bit to underflow.
constexpr bool has_range = std::numeric_limits<long double>::max_exponent > 7 * 1024 + 16 &&
                           std::numeric_limits<long double>::min_exponent < -7 * 1074 - 256;

/// A number that is off by `error` at most.
struct About {
    long double value, error;

    bool is_positive() const { return value > error; }
    bool is_negative() const { return value < -error; }
    bool is_known() const { return is_positive() || is_negative(); }
    /// The relative error.
    long double part() const { return error / std::abs(value); }
};

/// Above this relative error the bounds on a quotient are not good enough.
constexpr long double too_much = 0x1p-10L;

Meeting meeting_at(std::size_t surface, long double t, long double part) {
    const long double slack = t * (2 * part + 16 * u);
    return {surface, t - slack, t + slack};
}

bool is_number(const Point& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

}  // namespace

Oracle::Oracle(Surfaces surfaces, Rule rule) : surfaces_(std::move(surfaces)), rule_(rule) {
    // A difference is off by u of itself; a product of two of them by 3u, and a difference of products by 4u of the
    // products' sizes.
    const auto less = [](const Point& a, const Point& b) {
        const long double x = static_cast<long double>(a.x) - b.x, y = static_cast<long double>(a.y) - b.y,
                          z = static_cast<long double>(a.z) - b.z;
        return Rounded{x, y, z, std::abs(x), std::abs(y), std::abs(z)};
    };
    for (const auto& [A, B, C] : surfaces_.triangles) {
        const Rounded E = less(B, A), F = less(C, A);
        const Rounded N{E.y * F.z - E.z * F.y,
                        E.z * F.x - E.x * F.z,
                        E.x * F.y - E.y * F.x,
                        std::abs(E.y * F.z) + std::abs(E.z * F.y),
                        std::abs(E.z * F.x) + std::abs(E.x * F.z),
                        std::abs(E.x * F.y) + std::abs(E.y * F.x)};
        edges_.push_back({E, F, N});
    }
}

Answer Oracle::operator()(const Ray& ray) const {
    Answer answer;
    answer.valid = is_number(ray.P) && is_number(ray.D) && (ray.D.x != 0 || ray.D.y != 0 || ray.D.z != 0);
    if (!answer.valid) return answer;
    for (std::size_t surface = 0; surface < surfaces_.size(); ++surface) {
        const std::optional<Meeting> meeting = meet(surface, ray);
        if (!meeting) continue;
        answer.met.push_back(*meeting);
        if (!answer.first || compare(ray, *meeting, *answer.first) <= 0) answer.first = meeting;
    }
    return answer;
}

std::optional<Meeting> Oracle::meet(std::size_t surface, const Ray& ray) const {
    if constexpr (!has_range) return meet_exactly(surface, ray);
    else return surface < surfaces_.spheres.size() ? meet_sphere(surface, ray) : meet_triangle(surface, ray);
}

std::optional<Meeting> Oracle::meet_exactly(std::size_t surface, const Ray& ray) const {
    const std::optional<Distance> t = t_of(surfaces_, rule_, surface, ray);
    if (!t) return {};
    if constexpr (!has_range) return Meeting{surface, 0, std::numeric_limits<long double>::infinity()};
    else return meeting_at(surface, static_cast<long double>(t->size), u);
}

std::optional<Meeting> Oracle::meet_triangle(std::size_t surface, const Ray& ray) const {
    const auto& [E, F, N] = edges_[surface - surfaces_.spheres.size()];
    const Point& A = surfaces_.triangles[surface - surfaces_.spheres.size()].A;
    const auto& [dx, dy, dz] = ray.D;
    const long double x = static_cast<long double>(ray.P.x) - A.x, y = static_cast<long double>(ray.P.y) - A.y,
                      z = static_cast<long double>(ray.P.z) - A.z;
    // M = T × D, off by 3u of the sizes; what it is multiplied with is off by 4u, the sum of the products by 3u more.
    const Rounded M{y * dz - z * dy,
                    z * dx - x * dz,
                    x * dy - y * dx,
                    std::abs(y * dz) + std::abs(z * dy),
                    std::abs(z * dx) + std::abs(x * dz),
                    std::abs(x * dy) + std::abs(y * dx)};
    const auto product = [](const Rounded& a, const Rounded& b) {
        return About{a.x * b.x + a.y * b.y + a.z * b.z,
                     16 * u * (a.size_x * b.size_x + a.size_y * b.size_y + a.size_z * b.size_z)};
    };
    const About v = product(E, M), minus_u = product(F, M);
    if (!rule_.tolerance && ((v.is_positive() && minus_u.is_positive()) || (v.is_negative() && minus_u.is_negative())))
        return {};
    const Rounded D{dx,
                    dy,
                    dz,
                    std::abs(static_cast<long double>(dx)),
                    std::abs(static_cast<long double>(dy)),
                    std::abs(static_cast<long double>(dz))};
    const Rounded T{x, y, z, std::abs(x), std::abs(y), std::abs(z)};
    const About all = product(D, N), minus_t = product(T, N);
    if (!all.is_known() || !minus_t.is_known()) return meet_exactly(surface, ray);
    const bool turned = all.is_negative();
    if (minus_t.is_positive() != turned) return {};
    const About rest{all.value - v.value + minus_u.value,
                     all.error + v.error + minus_u.error +
                         4 * u * (std::abs(all.value) + std::abs(v.value) + std::abs(minus_u.value))};
    const About weights[] = {turned ? About{-v.value, v.error} : v,
                             turned ? minus_u : About{-minus_u.value, minus_u.error},
                             turned ? About{-rest.value, rest.error} : rest};
    bool is_sure = true, is_outside = false;
    for (const About& weight : weights) {
        is_sure = is_sure && weight.is_known();
        is_outside = is_outside || weight.is_negative();
    }
    if (is_outside && !rule_.tolerance) return {};
    if (!is_sure || rule_.tolerance) return meet_exactly(surface, ray);
    const long double part = all.part() + minus_t.part();
    if (!(part < too_much)) return meet_exactly(surface, ray);
    return meeting_at(surface, -minus_t.value / all.value, part);
}

std::optional<Meeting> Oracle::meet_sphere(std::size_t surface, const Ray& ray) const {
    const auto& [centre, radius] = surfaces_.spheres[surface];
    const long double x = static_cast<long double>(ray.P.x) - centre.x,
                      y = static_cast<long double>(ray.P.y) - centre.y,
                      z = static_cast<long double>(ray.P.z) - centre.z;
    const long double dx = ray.D.x, dy = ray.D.y, dz = ray.D.z, r = radius;
    const long double a = dx * dx + dy * dy + dz * dz, f2 = x * x + y * y + z * z, r2 = r * r;
    // b is off by 5u of its terms' sizes, c by 6u, a by 3u. So b² is by 11u, ac by 10u of a(f² + r²).
    const long double size_b = std::abs(x * dx) + std::abs(y * dy) + std::abs(z * dz);
    const About b{x * dx + y * dy + z * dz, 8 * u * size_b}, c{f2 - r2, 12 * u * (f2 + r2)};
    const About quarter{b.value * b.value - a * c.value, 32 * u * (size_b * size_b + a * (f2 + r2))};
    if (quarter.is_negative() || (c.is_positive() && b.is_positive())) return {};
    if (!quarter.is_known() || !b.is_known() || !c.is_known()) return meet_exactly(surface, ray);
    const long double part = quarter.part() + b.part() + c.part();
    if (!(part < too_much)) return meet_exactly(surface, ray);
    const long double root = std::sqrt(quarter.value);
    const long double t = c.is_positive()   ? c.value / (root - b.value)
                          : b.is_negative() ? (root - b.value) / a
                                            : -c.value / (root + b.value);
    return meeting_at(surface, t, part);
}

int Oracle::compare(const Ray& ray, const Meeting& one, const Meeting& other) const {
    if (one.high < other.low) return -1;
    if (one.low > other.high) return 1;
    return oracle::compare(*t_of(surfaces_, rule_, one.surface, ray), *t_of(surfaces_, rule_, other.surface, ray));
}

int Oracle::compare(const Ray& ray, const Meeting& meeting, std::initializer_list<double> sum) const {
    return oracle::compare(*t_of(surfaces_, rule_, meeting.surface, ray), sum_of(sum));
}

bool Oracle::is_within(const Ray& ray, const Meeting& meeting, long double t, double error) const {
    if (!(error >= 0)) return false;
    if (std::isinf(error)) return true;
    if (!std::isfinite(t)) return false;
    const long double slack = 4 * u * (std::abs(t) + error);
    if (meeting.low >= t - error + slack && meeting.high <= t + error - slack) return true;
    const auto head = static_cast<double>(t), tail = static_cast<double>(t - head);
    return compare(ray, meeting, {head, tail, -error}) >= 0 && compare(ray, meeting, {head, tail, error}) <= 0;
}

long double Oracle::error_of(const Ray& ray, const Meeting& meeting, long double t) const {
    return static_cast<long double>(abs(Long(t) - t_of(surfaces_, rule_, meeting.surface, ray)->size));
}

std::string Oracle::t_text(const Ray& ray, const Meeting& meeting, int digits) const {
    return t_of(surfaces_, rule_, meeting.surface, ray)->size.str(digits);
}

Normal Oracle::normal(const Ray& ray, const Meeting& meeting) const {
    const auto norm = [](long double x, long double y, long double z) { return std::sqrt(x * x + y * y + z * z); };
    const auto made_unit = [&](const Rounded& n, long double more) {
        const long double length = norm(n.x, n.y, n.z), size = norm(n.size_x, n.size_y, n.size_z) + more;
        const auto part = [&](long double x) { return static_cast<double>(x / length); };
        return Normal{{part(n.x), part(n.y), part(n.z)}, part(size)};
    };
    if (meeting.surface >= surfaces_.spheres.size())
        return made_unit(edges_[meeting.surface - surfaces_.spheres.size()].N, 0);
    const auto& [c, r] = surfaces_.spheres[meeting.surface];
    const long double t = (meeting.low + meeting.high) / 2;
    const long double x = static_cast<long double>(ray.P.x) - c.x, y = static_cast<long double>(ray.P.y) - c.y,
                      z = static_cast<long double>(ray.P.z) - c.z;
    const long double dx = ray.D.x, dy = ray.D.y, dz = ray.D.z, d = norm(dx, dy, dz);
    const auto size = [t](double P, long double D, double its_c) {
        return std::abs(static_cast<long double>(P)) + std::abs(t * D) + std::abs(static_cast<long double>(its_c));
    };
    // The half chord is s = √(r² − l²), and its square has the rounding error of f² + r²; so where the ray grazes, s is
    // off by the root of that.
    const long double f = norm(x, y, z), b = (x * dx + y * dy + z * dz) / d;
    const long double square = b * b - f * f + static_cast<long double>(r) * r;
    const long double off = 0x1p-48L * (f * f + static_cast<long double>(r) * r);
    const long double off_chord = off / std::sqrt(std::max(square, off));
    return made_unit(
        {x + t * dx, y + t * dy, z + t * dz, size(ray.P.x, dx, c.x), size(ray.P.y, dy, c.y), size(ray.P.z, dz, c.z)},
        0x1p50L * off_chord);
}

// Views

namespace {

struct LongVector {
    Long x, y, z;

    friend LongVector operator+(const LongVector& a, const LongVector& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
    friend LongVector operator-(const LongVector& a, const LongVector& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
    friend LongVector operator*(const Long& s, const LongVector& a) { return {s * a.x, s * a.y, s * a.z}; }
};

LongVector to_long(const Point& p) { return {Long(p.x), Long(p.y), Long(p.z)}; }

LongVector cross(const LongVector& a, const LongVector& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

Long length(const LongVector& a) { return sqrt(Long(a.x * a.x + a.y * a.y + a.z * a.z)); }

bool same(const Point& a, const Point& b) { return a.x == b.x && a.y == b.y && a.z == b.z; }

constexpr double wrong = std::numeric_limits<double>::infinity();
const Long rounding = ldexp(Long(1), -53);

/// Each coordinate is rounded four times at most, relatively to what it is the sum of, and may underflow.
double ray_error(const Parallel& view, int, int, int j, int i, const Ray& ray) {
    if (!same(ray.D, view.direction)) return wrong;
    Long worst = 0;
    const auto look = [&](double corner, double right, double up, double is) {
        if (!std::isfinite(is)) {
            worst = Long(wrong);
            return;
        }
        const Long to_right = Long(j) * Long(right), to_up = Long(i) * Long(up);
        const Long bound = 4 * rounding * (abs(Long(corner)) + abs(to_right) + abs(to_up)) + ldexp(Long(1), -1072);
        worst = std::max(worst, Long(abs(Long(corner) + to_right + to_up - Long(is)) / bound));
    };
    look(view.corner.x, view.right.x, view.up.x, ray.P.x);
    look(view.corner.y, view.right.y, view.up.y, ray.P.y);
    look(view.corner.z, view.right.z, view.up.z, ray.P.z);
    return static_cast<double>(worst);
}

/// All vectors but `up` are found from look_at − eye, whose every coordinate is rounded once; so they are right to a
/// dozen roundings, and those across to so many times 1/sin of the angle between forward and up. The tangent of
/// half the field of view is right to 8 roundings times x/(sin x cos x), by which it magnifies those of x.
double ray_error(const Pinhole& view, int width, int height, int j, int i, const Ray& ray) {
    if (!same(ray.P, view.eye) || !is_number(ray.D)) return wrong;
    const LongVector ahead = to_long(view.look_at) - to_long(view.eye), up = to_long(view.up);
    const LongVector forward = (1 / length(ahead)) * ahead, across = cross(forward, up);
    const LongVector right = (1 / length(across)) * across, above = cross(right, forward);
    const Long half = Long(view.field_of_view) / 360 * boost::math::constants::pi<Long>();
    const Long pixel = 2 * tan(half) / height;
    const LongVector D =
        forward + (Long(2 * j - width + 1) / 2 * pixel) * right + (Long(2 * i - height + 1) / 2 * pixel) * above;
    const Long by_up = length(up) / length(across), by_angle = half / (sin(half) * cos(half));
    const Long bound = 24 * rounding * (1 + pixel * (width + height) * (by_up + by_angle));
    const LongVector off = D - to_long(ray.D);
    return static_cast<double>(std::max({Long(abs(off.x)), Long(abs(off.y)), Long(abs(off.z))}) / bound);
}

}  // namespace

double ray_error(const View& view, int width, int height, int j, int i, const Ray& ray) {
    return std::visit([&](const auto& v) { return ray_error(v, width, height, j, i, ray); }, view);
}

}  // namespace oracle
