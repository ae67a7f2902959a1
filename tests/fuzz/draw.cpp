#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "drawn.hpp"
#include "random.hpp"

namespace glassbox::fuzz {

namespace {

using oracle::Parallel, oracle::Pinhole, oracle::Point, oracle::Ray, oracle::Sphere, oracle::Triangle;

Point operator+(const Point& a, const Point& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
Point operator-(const Point& a, const Point& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
Point operator*(double s, const Point& a) { return {s * a.x, s * a.y, s * a.z}; }
Point cross(const Point& a, const Point& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
double greatest(const Point& a) { return std::max({std::abs(a.x), std::abs(a.y), std::abs(a.z)}); }
double length(const Point& a) { return std::sqrt(a.x * a.x + a.y * a.y + a.z * a.z); }
Point unit(const Point& a) { return 1 / length(a) * a; }
bool is_zero(const Point& a) { return a.x == 0 && a.y == 0 && a.z == 0; }

double& axis(Point& p, int k) { return k == 0 ? p.x : k == 1 ? p.y : p.z; }

Point along(int k, double s) {
    Point p;
    axis(p, k) = s;
    return p;
}

/// A point whose coordinates are integers of so many bits.
Point on_lattice(Random& random, int bits) {
    return {random.few_bits(bits), random.few_bits(bits), random.few_bits(bits)};
}
Point anywhere(Random& random) {
    return {2 * random.fraction() - 1, 2 * random.fraction() - 1, 2 * random.fraction() - 1};
}
/// A direction of integers, often along an axis.
Point direction(Random& random, int bits) {
    if (random.one_in(2)) return along(random.between(0, 2), random.sign());
    for (;;)
        if (const Point D = on_lattice(random, bits); !is_zero(D)) return D;
}

/// Exponents at which products of two to seven numbers leave the range of doubles, floats or bounds; and any.
int exponent(Random& random) {
    if (random.one_in(3)) return random.between(-1060, 1000);
    return random.of({-1040, -1022, -537, -511, -485, -358, -341, -269, -256, -204, -170, -153, -127, -100, -75, -50,
                      50,    75,    100,  127,  153,  170,  204,  256,  269,  341,  358,  511,  537,  900,  980}) +
           random.between(-6, 6);
}

/// Calls `use` with each coordinate and each length of the surfaces.
template <class Use>
void for_each_number(oracle::Surfaces& surfaces, const Use& use) {
    const auto point = [&](Point& p) {
        use(p.x);
        use(p.y);
        use(p.z);
    };
    for (auto& [c, r] : surfaces.spheres) {
        point(c);
        use(r);
    }
    for (auto& [A, B, C] : surfaces.triangles) {
        point(A);
        point(B);
        point(C);
    }
}

/// Calls `use` with each point and each vector of the surfaces.
template <class Use>
void for_each_point(oracle::Surfaces& surfaces, const Use& use) {
    for (Sphere& sphere : surfaces.spheres) use(sphere.c);
    for (auto& [A, B, C] : surfaces.triangles) {
        use(A);
        use(B);
        use(C);
    }
}

Triangle reordered(Random& random, Triangle t) {
    if (random.one_in(2)) std::swap(t.A, t.B);
    if (random.one_in(2)) std::swap(t.B, t.C);
    return t;
}

// Views

/// Pixels on whole multiples of a step, or half of one beside them; the rays start `away` from the middle.
Parallel aligned_view(Random& random, const Point& middle, double size, int side, double away) {
    const int k = random.between(0, 2);
    const double step = std::exp2(std::ceil(std::log2(2 * size / side)));
    const Point right = along((k + 1) % 3, random.sign() * step), up = along((k + 2) % 3, random.sign() * step);
    const Point D = along(k, random.sign());
    const double shift = random.one_in(2) ? 0 : 0.5;
    return {middle - away * D - (side / 2 + shift) * right - (side / 2 + shift) * up, right, up, D};
}

/// Any directions, in whole numbers or not.
Parallel skew_view(Random& random, const Point& middle, double size, int side, double away) {
    const bool whole = random.one_in(2);
    for (;;) {
        const auto any = [&] { return whole ? on_lattice(random, 2) : anywhere(random); };
        const Point D = any(), to_right = any(), to_up = any();
        const Point n = cross(to_right, to_up);
        if (std::abs(n.x * D.x + n.y * D.y + n.z * D.z) < 1e-3) continue;
        const double step = whole ? std::exp2(std::ceil(std::log2(size / side))) : 2 * size / side;
        const Point right = step * to_right, up = step * to_up;
        const double steps = whole ? std::ceil(away / greatest(D)) : away / length(D);
        return {middle - steps * D - (side / 2) * right - (side / 2) * up, right, up, D};
    }
}

Pinhole pinhole_view(Random& random, const Point& middle, double size, double away) {
    for (;;) {
        Pinhole view;
        view.eye = random.one_in(2) ? middle + away * direction(random, 2) : middle + 2 * away * anywhere(random);
        view.look_at = random.one_in(2) ? middle : middle + 0.25 * size * on_lattice(random, 2);
        view.up = random.one_in(2) ? along(random.between(0, 2), 1) : anywhere(random);
        view.field_of_view = random.of({90.0, 90.0, 60.0, 45.0, 20.0, 1.0, 120.0, 170.0});
        const Point ahead = view.look_at - view.eye;
        if (!is_zero(ahead) && length(cross(unit(ahead), unit(view.up))) > 1e-3) return view;
    }
}

/// Sets a view of what lies within `size` of the middle, from outside or from within.
void look(Random& random, Drawn& drawn, const Point& middle, double size, int least_side = 6, int most_side = 28) {
    const int side = random.between(least_side, most_side);
    drawn.width = drawn.height = side;
    if (random.one_in(3)) drawn.width = random.between(1, most_side);
    const double away = random.one_in(4) ? size * random.of({0.0, 0.25, 0.5, 1.0}) : size * random.of({2.0, 3.0, 8.0});
    switch (random.below(3)) {
        case 0:
            drawn.view = aligned_view(random, middle, size, side, away);
            break;
        case 1:
            drawn.view = skew_view(random, middle, size, side, away);
            break;
        default:
            drawn.view = pinhole_view(random, middle, size, std::max(away, size / 4));
    }
}

// Kinds of scenes

/// Few bits: vertices, edges and channels that many surfaces share, spheres that touch, rays exactly through all of
/// them.
Drawn lattice(Random& random) {
    Drawn drawn;
    const int bits = random.between(1, 5);
    std::vector<Point> pool(static_cast<std::size_t>(random.between(3, 8)));
    for (Point& p : pool) p = on_lattice(random, bits);
    const auto point = [&] { return random.one_in(4) ? on_lattice(random, bits) : random.of_list(pool); };
    for (int n = random.between(0, 8); n > 0; --n) {
        drawn.surfaces.triangles.push_back({point(), point(), point()});
        if (random.one_in(4)) drawn.surfaces.triangles.push_back(reordered(random, drawn.surfaces.triangles.back()));
    }
    for (int n = random.between(drawn.surfaces.triangles.empty() ? 1 : 0, 4); n > 0; --n) {
        const double r = random.between(1, 1 << bits);
        drawn.surfaces.spheres.push_back({point(), r});
        const Sphere last = drawn.surfaces.spheres.back();
        if (random.one_in(3)) {
            const double other = random.between(1, 1 << bits);
            drawn.surfaces.spheres.push_back(
                {last.c + along(random.between(0, 2), last.r + random.sign() * other), other});
        }
        if (random.one_in(4)) drawn.surfaces.spheres.push_back(last);
    }
    look(random, drawn, {}, 1 << bits);
    return drawn;
}

/// A triangle that a ray meets where all weights are equal, so far away that they are about as large as their rounding
/// errors may be: a few roundings of the sizes of the products that they are sums of. Something stands in front of it.
Drawn balanced(Random& random) {
    Drawn drawn;
    const double roundings = random.one_in(4) ? random.between(1, 40) : random.of({8.0, 9.0, 9.0, 20.0});
    const double s = random.power_of_two(-8, 0), y = s * random.power_of_two(16, 30);
    // With A at (y − s, z − s) and so on each weight is 3s², and the sizes of its products are about 8yz, if sizes are
    // those of the coordinates of vertices and start added. z is searched for so that it matches to the last bit.
    const auto weight_over_bound = [&](double z) {
        const double ay = 2 * y - s, by = 2 * y + 2 * s, az = 2 * z - s, cz = 2 * z + 2 * s;
        const double ab = ay * az + az * by, bc = by * cz + az * ay, ca = cz * ay + ay * az;
        return 3 * s * s / (roundings * 0x1p-53 * std::max({ab, bc, ca}));
    };
    double low = 0, high = 16 * 3 * s * s / (roundings * 0x1p-53 * y);
    while (std::nextafter(low, high) < high) {
        const double middle = low + (high - low) / 2;
        (weight_over_bound(middle) >= 1 ? low : high) = middle;
    }
    double z = low;
    if (random.one_in(4)) z *= 1 - random.power_of_two(-52, -1);
    else
        for (std::uint64_t n = random.below(24); n > 0; --n) z = std::nextafter(z, 0);
    // It reaches from in front of the nearer surface to behind it, so that it is tested first.
    const double start = random.of({64.0, 100.0, 1024.0}), nearer = random.between(12, 40),
                 size = random.of({1.0, 4.0});
    const double x[] = {random.one_in(4) ? 0.0 : nearer + 4, random.few_bits(3), random.few_bits(3)};
    drawn.surfaces.triangles.push_back({{x[0], y - s, z - s}, {x[1], y + 2 * s, z - s}, {x[2], y - s, z + 2 * s}});
    if (!random.one_in(3)) drawn.surfaces.spheres.push_back({{nearer, y, z}, random.of({0.25, 1.0, 4.0})});
    else
        drawn.surfaces.triangles.push_back(
            {{nearer, y - size, z - size}, {nearer, y + size, z - size}, {nearer, y, z + size}});
    const double step = random.of({s, s / 4, s / 64});
    drawn.view = Parallel{{start, y, z}, {0, step, 0}, {0, 0, step}, {-random.of({1.0, 1.0, 0.5, 3.0}), 0, 0}};
    drawn.width = drawn.height = random.between(1, 3);
    return drawn;
}

/// Surfaces of all sizes one behind the other.
Drawn sizes(Random& random) {
    Drawn drawn;
    const int n = random.between(2, 5), k = random.between(0, 2);
    const double ahead = random.sign();
    double last = 1;
    for (int i = 0; i < n; ++i) {
        // At the second the squares have few bits left.
        const int e = random.one_in(3)   ? exponent(random)
                      : random.one_in(3) ? random.between(-542, -522)
                                         : random.between(-40, 40);
        const double away = std::ldexp(random.of({1.0, 1.5, 1.25}), e);
        const double size = away * (random.one_in(3) ? random.power_of_two(-60, -3) : random.of({0.5, 0.25, 0.75}));
        if (!(away < 1e300) || size == 0) continue;
        const Point middle = along(k, ahead * away) + 0.25 * size * on_lattice(random, random.of({0, 1}));
        if (random.one_in(2)) {
            drawn.surfaces.spheres.push_back({middle, size});
        } else {
            const auto corner = [&](double a, double b) {
                return middle + along((k + 1) % 3, a * size) + along((k + 2) % 3, b * size) +
                       along(k, 0.125 * size * random.few_bits(1));
            };
            drawn.surfaces.triangles.push_back({corner(-4, -4), corner(4, -4), corner(0, 4)});
        }
        last = size;
    }
    const int side = random.between(3, 29);
    drawn.width = drawn.height = side;
    const Point to_right = along((k + 1) % 3, 1), to_up = along((k + 2) % 3, 1);
    if (random.one_in(2)) {
        drawn.view = Pinhole{{}, along(k, ahead), to_up, random.of({90.0, 60.0, 10.0})};
    } else {
        const double step = std::clamp(last * random.of({0.125, 0.0625, 0.3}), 1e-149, 1e149);
        drawn.view = Parallel{(-side / 2 * step) * (to_right + to_up), step * to_right, step * to_up, along(k, ahead)};
    }
    return drawn;
}

/// Spheres whose squares have few bits left, or none, all over the picture, and something of ordinary size behind.
Drawn tiny(Random& random) {
    Drawn drawn;
    const int k = random.between(0, 2);
    const double ahead = random.sign();
    for (int n = random.between(1, 2); n > 0; --n) {
        const int e = random.one_in(3) ? random.between(-542, -524) : random.between(-538, -535);
        const double away = std::ldexp(1 + random.fraction(), e);
        const Point beside = 0.25 * away * on_lattice(random, random.of({0, 1}));
        drawn.surfaces.spheres.push_back({along(k, ahead * away) + beside, away * random.of({0.5, 0.25, 0.75, 0.9})});
    }
    const auto corner = [&](double a, double b) {
        return along(k, ahead) + along((k + 1) % 3, a) + along((k + 2) % 3, b);
    };
    drawn.surfaces.triangles.push_back({corner(-5, -5), corner(5, -5), corner(0, 5)});
    drawn.width = drawn.height = random.between(24, 48);
    drawn.view = Pinhole{{}, along(k, ahead), along((k + 1) % 3, 1), random.of({90.0, 60.0, 45.0})};
    return drawn;
}

/// Pixels very close together where rays only just touch a sphere, and things that touch it there.
Drawn grazing(Random& random) {
    Drawn drawn;
    const double r = random.one_in(2) ? random.between(1, 30) : random.power_of_two(-20, 20) * (1 + random.fraction());
    const Point c = random.one_in(2) ? on_lattice(random, 6) : random.power_of_two(0, 30) * anywhere(random);
    Point D = random.one_in(2) ? direction(random, 2) : anywhere(random), beside;
    do beside = cross(D, anywhere(random));
    while (length(beside) < 1e-3 * length(D));
    if (random.one_in(2))
        for (int k = 0; k < 3; ++k)
            if (axis(D, k) == 0) beside = along(k, random.sign());
    beside = unit(beside);
    const Point other = unit(cross(beside, D)), touched = c + r * beside;
    drawn.surfaces.spheres.push_back({c, r});
    if (random.one_in(3)) drawn.surfaces.spheres.push_back({c, std::nextafter(r, random.of({0.0, 1e300}))});
    if (random.one_in(4)) drawn.surfaces.spheres.push_back({c, r});
    if (random.one_in(3)) drawn.surfaces.spheres.push_back({touched + r * beside, r});
    if (random.one_in(2))
        drawn.surfaces.triangles.push_back(
            {touched + r * other, touched - r * other - r * beside, touched - r * other + 2 * r * beside});
    const double step = r * random.power_of_two(-54, -4);
    const double across = random.one_in(2) ? step : r * random.power_of_two(-30, -4);
    const double away = r / length(D) * random.of({1.0, 3.0, 100.0, 1e4, 1e7});
    const int side = random.between(4, 20);
    drawn.width = drawn.height = side;
    drawn.view = Parallel{touched - away * D - (side / 2 * step) * beside - (side / 2 * across) * other, step * beside,
                          across * other, D};
    return drawn;
}

/// Triangles of hardly any area, or none.
Drawn slivers(Random& random) {
    Drawn drawn;
    const auto bent = [&](Point p) {
        axis(p, random.between(0, 2)) = std::nextafter(axis(p, random.between(0, 2)), random.sign() * 9);
        return p;
    };
    for (int n = random.between(1, 5); n > 0; --n) {
        const bool few = random.one_in(2);
        const Point A = few ? on_lattice(random, 3) : 4 * anywhere(random);
        const Point E = few ? on_lattice(random, 3) : 4 * anywhere(random), B = A + E;
        const Point C = A + random.of({0.5, 2.0, -1.0, 0.3, 1.0}) * E;
        const Point moved = random.one_in(3)   ? bent(C)
                            : random.one_in(2) ? C + random.power_of_two(-60, -20) * anywhere(random)
                                               : C;
        drawn.surfaces.triangles.push_back(reordered(random, {A, B, moved}));
        if (random.one_in(3)) drawn.surfaces.triangles.push_back({A, moved, B + 0.25 * anywhere(random)});
    }
    look(random, drawn, random.of_list(drawn.surfaces.triangles).A, 4);
    return drawn;
}

/// Nothing special, but many surfaces; some of them twice.
Drawn heap(Random& random) {
    Drawn drawn;
    const int n = random.of({3, 8, 20, 60});
    const double size = random.of({0.1, 0.5, 1.0});
    for (int i = 0; i < n; ++i) {
        const Point at = 2 * anywhere(random);
        if (random.one_in(3)) drawn.surfaces.spheres.push_back({at, size * (0.05 + 0.5 * random.fraction())});
        else
            drawn.surfaces.triangles.push_back(
                {at + size * anywhere(random), at + size * anywhere(random), at + size * anywhere(random)});
        if (random.one_in(12) && !drawn.surfaces.triangles.empty())
            drawn.surfaces.triangles.push_back(reordered(random, drawn.surfaces.triangles.back()));
        if (random.one_in(20) && !drawn.surfaces.spheres.empty())
            drawn.surfaces.spheres.push_back(drawn.surfaces.spheres.back());
    }
    look(random, drawn, {}, 2, 10, 44);
    return drawn;
}

/// A closed or open mesh of triangles that share edges and vertices.
Drawn mesh(Random& random) {
    Drawn drawn;
    std::vector<Triangle>& faces = drawn.surfaces.triangles;
    const double size = random.one_in(2) ? random.of({1.0, 4.0, 16.0}) : 1 + random.fraction();
    const auto octant = [&](double sx, double sy, double sz) {
        faces.push_back({{sx * size, 0, 0}, {0, sy * size, 0}, {0, 0, sz * size}});
    };
    if (random.one_in(3)) {
        const int n = random.between(3, 16);
        for (int i = 0; i < n; ++i) {
            const auto rim = [&](int k) {
                const double angle = 6.283185307179586 * (k % n) / n;
                return size * Point{std::cos(angle), std::sin(angle), 0};
            };
            faces.push_back({{0, 0, random.one_in(2) ? 0 : size}, rim(i), rim(i + 1)});
        }
    } else {
        for (const double sx : {1.0, -1.0})
            for (const double sy : {1.0, -1.0})
                for (const double sz : {1.0, -1.0}) octant(sx, sy, sz);
        for (int splits = random.between(0, 2); splits > 0; --splits) {
            const bool round = random.one_in(2);
            const std::vector<Triangle> coarse = std::exchange(faces, {});
            for (const auto& [A, B, C] : coarse) {
                const auto between = [&](const Point& p, const Point& q) {
                    const Point middle = 0.5 * (p + q);
                    return round ? size * unit(middle) : middle;
                };
                const Point ab = between(A, B), bc = between(B, C), ca = between(C, A);
                faces.insert(faces.end(), {{A, ab, ca}, {ab, B, bc}, {ca, bc, C}, {ab, bc, ca}});
            }
        }
    }
    look(random, drawn, {}, size);
    return drawn;
}

/// More surfaces than the plain loop is used for.
Drawn many(Random& random) {
    Drawn drawn;
    const int side = 33;
    const bool flat = random.one_in(2);
    const auto height = [&](int x, int y) { return flat ? 0.0 : static_cast<double>((x * 7 + y * 13) % 5); };
    const auto at = [&](int x, int y) { return Point{static_cast<double>(x), static_cast<double>(y), height(x, y)}; };
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x) {
            drawn.surfaces.triangles.push_back({at(x, y), at(x + 1, y), at(x, y + 1)});
            drawn.surfaces.triangles.push_back({at(x + 1, y), at(x + 1, y + 1), at(x, y + 1)});
        }
    drawn.surfaces.spheres.push_back({{16, 16, 2}, 3});
    look(random, drawn, {16, 16, 0}, 16, 8, 14);
    return drawn;
}

struct Kind {
    std::string_view name;
    Drawn (*draw)(Random&);
    int share;
};

constexpr std::array all_kinds{Kind{"lattice", lattice, 28}, Kind{"balanced", balanced, 10}, Kind{"sizes", sizes, 14},
                               Kind{"grazing", grazing, 12}, Kind{"slivers", slivers, 8},    Kind{"heap", heap, 12},
                               Kind{"tiny", tiny, 4},        Kind{"mesh", mesh, 11},         Kind{"many", many, 1}};

/// Each kind has its share of any hundred consecutive seeds, well mixed.
const Kind& kind_of(std::uint64_t seed, std::string_view name) {
    int left = static_cast<int>(seed * 37 % 100);
    for (const Kind& kind : all_kinds) {
        if (name.empty() ? left < kind.share : kind.name == name) return kind;
        left -= kind.share;
    }
    return all_kinds[0];
}

// Changes that may be applied to a scene of any kind

/// Coordinates an ulp or a few off.
void jitter(Random& random, Drawn& drawn) {
    for_each_number(drawn.surfaces, [&](double& x) {
        if (!random.one_in(3)) return;
        for (std::uint64_t n = random.below(3); n > 0; --n) x = std::nextafter(x, random.sign() * 1e308);
        if (x == 0) x = random.sign() * random.power_of_two(-1074, -40);
    });
    for (Sphere& sphere : drawn.surfaces.spheres) sphere.r = std::abs(sphere.r);
}

/// Puts a triangle behind everything: the box around all surfaces becomes large.
void put_behind(Random& random, Drawn& drawn) {
    const double size = random.power_of_two(10, 30);
    const Point n = std::holds_alternative<Parallel>(drawn.view)
                        ? unit(std::get<Parallel>(drawn.view).direction)
                        : unit(std::get<Pinhole>(drawn.view).look_at - std::get<Pinhole>(drawn.view).eye);
    const Point from = std::holds_alternative<Parallel>(drawn.view) ? std::get<Parallel>(drawn.view).corner
                                                                    : std::get<Pinhole>(drawn.view).eye;
    Point beside = cross(n, {n.y, n.z, n.x});
    if (length(beside) < 1e-3) beside = cross(n, {0.5, -0.25, 1});
    const Point a = size * unit(beside), b = cross(n, a), middle = from + size * n;
    drawn.surfaces.triangles.push_back({middle - 3 * a - b, middle + 3 * a - b, middle + 3 * b});
}

/// Calls `use` with each point of the view.
template <class Use>
void for_each_place(oracle::View& view, const Use& use) {
    if (auto* parallel = std::get_if<Parallel>(&view)) return use(parallel->corner);
    use(std::get<Pinhole>(view).eye);
    use(std::get<Pinhole>(view).look_at);
}

template <class Use>
void for_each_direction(oracle::View& view, const Use& use) {
    if (auto* parallel = std::get_if<Parallel>(&view)) {
        use(parallel->right);
        use(parallel->up);
        use(parallel->direction);
    } else {
        use(std::get<Pinhole>(view).up);
    }
}

/// Moves everything somewhere else.
void move(Random& random, Drawn& drawn) {
    const Point by = random.power_of_two(2, 50) * on_lattice(random, 2);
    const auto moved = [&](Point& p) { p = p + by; };
    for_each_point(drawn.surfaces, moved);
    for_each_place(drawn.view, moved);
}

/// Permutes x, y and z.
void turn(Random& random, Drawn& drawn) {
    const int times = random.between(0, 2);
    const auto turned = [&](Point& p) {
        for (int i = 0; i < times; ++i) p = {p.y, p.z, p.x};
    };
    for_each_point(drawn.surfaces, turned);
    for_each_place(drawn.view, turned);
    for_each_direction(drawn.view, turned);
}

bool is_finite(const Drawn& drawn) {
    Drawn copy = drawn;
    bool finite = true;
    const auto number = [&](double x) { finite = finite && std::isfinite(x); };
    const auto point = [&](const Point& p) { number(p.x + p.y + p.z); };
    for_each_number(copy.surfaces, number);
    for_each_place(copy.view, point);
    for_each_direction(copy.view, point);
    for (const Sphere& sphere : copy.surfaces.spheres) finite = finite && sphere.r > 0;
    return finite;
}

/// Scales everything by a power of two; steps and directions only within the range that scene files allow.
void scale(Random& random, Drawn& drawn) {
    const int e = exponent(random);
    Drawn scaled = drawn;
    const auto times = [](Point& p, int by) { p = {std::ldexp(p.x, by), std::ldexp(p.y, by), std::ldexp(p.z, by)}; };
    for_each_number(scaled.surfaces, [&](double& x) { x = std::ldexp(x, e); });
    for_each_place(scaled.view, [&](Point& p) { times(p, e); });
    if (auto* view = std::get_if<Parallel>(&scaled.view)) {
        const int steps = std::clamp(e, -440, 440);
        times(view->right, steps);
        times(view->up, steps);
        if (random.one_in(2)) times(view->direction, random.of({steps, -steps, random.between(-440, 440)}));
    }
    if (is_finite(scaled)) drawn = std::move(scaled);
}

// Rays

/// A special point of a surface, or any point of it.
Point target(Random& random, const oracle::Surfaces& surfaces) {
    const std::size_t n = random.below(surfaces.size());
    if (n < surfaces.spheres.size()) {
        const auto& [c, r] = surfaces.spheres[n];
        if (random.one_in(3)) return c;
        return c + (random.one_in(2) ? along(random.between(0, 2), random.sign() * r) : r * unit(anywhere(random)));
    }
    const auto& [A, B, C] = surfaces.triangles[n - surfaces.spheres.size()];
    const auto part = [&] { return random.one_in(2) ? random.between(0, 8) / 8.0 : random.fraction(); };
    switch (random.below(4)) {
        case 0:
            return random.of({A, B, C});
        case 1:
            return random.of({A + part() * (B - A), B + part() * (C - B), C + part() * (A - C)});
        default:
            return A + part() * (B - A) + 0.5 * part() * (C - A);
    }
}

Ray any_ray(Random& random, const oracle::Surfaces& surfaces) {
    const Point Q = target(random, surfaces), other = target(random, surfaces);
    const double size = std::max({greatest(Q - other), greatest(Q) * 0x1p-30, 0x1p-1074});
    const double step = std::exp2(std::clamp(std::floor(std::log2(size)), -1074.0, 1020.0));
    Ray ray;
    switch (random.below(6)) {
        case 0:
            ray = {other, Q - other};
            break;
        case 1:  // it starts on a surface
            ray = {Q, random.one_in(2) ? direction(random, 2) : anywhere(random)};
            break;
        case 2:
            ray = {other + step * anywhere(random), {}};
            ray.D = Q - ray.P;
            break;
        case 3:
            ray.D = random.one_in(2) ? Q - other : step * direction(random, 3);
            ray.P = Q - random.of({1.0, 2.0, 0.5, 0x1p20}) * ray.D;
            break;
        default:
            ray.D = step * random.of({1.0, 0.25}) * direction(random, 3);
            ray.P = Q - static_cast<double>(random.between(1, 4)) * ray.D;
    }
    if (random.one_in(4)) {
        const int e = random.one_in(2) ? random.between(-60, 60) : exponent(random);
        ray.D = {std::ldexp(ray.D.x, e), std::ldexp(ray.D.y, e), std::ldexp(ray.D.z, e)};
    }
    if (random.one_in(8)) {
        double& x = axis(random.one_in(2) ? ray.P : ray.D, random.between(0, 2));
        x = std::nextafter(x, random.sign() * 1e308);
    }
    if (random.one_in(200))
        axis(random.one_in(2) ? ray.P : ray.D, random.between(0, 2)) =
            random.of({std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()});
    if (random.one_in(200)) ray.D = {0, -0.0, 0};
    return ray;
}

}  // namespace

Drawn draw(std::uint64_t seed, std::string_view name) {
    Random random(seed);
    const Kind& kind = kind_of(seed, name);
    Drawn drawn = kind.draw(random);
    drawn.kind = kind.name;
    if (random.one_in(4)) jitter(random, drawn);
    if (random.one_in(kind.draw == balanced ? 2 : 4)) put_behind(random, drawn);
    if (random.one_in(4) && kind.draw != balanced && kind.draw != tiny) move(random, drawn);
    turn(random, drawn);
    if (random.one_in(3) && kind.draw != tiny) scale(random, drawn);
    if (drawn.surfaces.size() == 0) drawn.surfaces.spheres.push_back({{}, 1});
    for (int n = 0; n < 32; ++n) drawn.rays.push_back(any_ray(random, drawn.surfaces));
    return drawn;
}

std::vector<std::string_view> kinds() {
    std::vector<std::string_view> names;
    for (const Kind& kind : all_kinds) names.push_back(kind.name);
    return names;
}

}  // namespace glassbox::fuzz
