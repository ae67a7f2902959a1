#include "slow.hpp"

#include <cmath>
#include <numbers>

#include "random.hpp"

namespace glassbox::fuzz {

namespace {

using oracle::Point;
using oracle::Sphere;
using oracle::Triangle;

Point operator+(const Point& a, const Point& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
Point operator*(double s, const Point& a) { return {s * a.x, s * a.y, s * a.z}; }

/// Draws one scene. Before it is scaled and moved it lies between −1 and 1.
class SlowScene {
public:
    explicit SlowScene(std::uint64_t seed) : random_(seed) {}

    Drawn operator()() {
        const int populations = random_.between(1, 2);
        for (int k = 0; k < populations; ++k) add_population();
        if (random_.one_in(3)) round_to_few_bits();
        if (random_.one_in(4)) copy_all();
        if (random_.one_in(3)) add_odd_one();
        choose_view();
        if (random_.one_in(4)) scale(std::ldexp(1, random_.of({-300, -100, -60, -50, -20, 20, 50, 60, 100, 300})));
        if (random_.one_in(4)) move(std::pow(10, random_.between(2, 12)));
        drawn_.width = drawn_.height = 64;
        return std::move(drawn_);
    }

private:
    double coordinate() { return 2 * random_.fraction() - 1; }
    Point point() {
        const double x = coordinate(), y = coordinate();
        return {x, y, coordinate()};
    }
    void add(const Triangle& triangle) { drawn_.surfaces.triangles.push_back(triangle); }
    void add(const Sphere& sphere) { drawn_.surfaces.spheres.push_back(sphere); }
    void say(const std::string& what) { drawn_.kind += (drawn_.kind.empty() ? "" : ", ") + what; }

    void add_population() {
        const int count = 1 << random_.between(4, 10);
        const auto times = [count](const auto& work) {
            for (int i = 0; i < count; ++i) work(i);
        };
        const auto said = [&](const char* what) { say(std::to_string(count) + " " + what); };
        switch (random_.below(12)) {
            case 0:
                said("triangles");
                return times([&](int) {
                    const Point A = point();
                    const Point B = A + 0.1 * point();
                    add(Triangle{A, B, A + 0.1 * point()});
                });
            case 1:
                said("long triangles");
                return times([&](int) {
                    const Point A = point(), B = point();
                    add(Triangle{A, B, point()});
                });
            case 2: {
                said("slivers");
                const double thin = random_.power_of_two(-50, -5);
                return times([&](int) {
                    const Point A = point(), B = point();
                    add(Triangle{A, B, B + thin * point()});
                });
            }
            case 3:
            case 4: {
                const double height = random_.of({0.0, 0.0, 0.1});
                said(height == 0 ? "triangles of a plane" : "triangles of a field");
                return add_field(count, height);
            }
            case 5: {
                said("triangles about a corner");
                const Point middle = random_.one_in(2) ? Point{} : point();
                const auto rim = [&](int i) {
                    const double angle = 2 * std::numbers::pi * i / count;
                    return middle + Point{std::cos(angle), std::sin(angle), 0.1 * std::cos(5 * angle)};
                };
                return times([&](int i) { add(Triangle{middle, rim(i), rim(i + 1)}); });
            }
            case 6: {
                const double apart = random_.of({0.0, 0x1p-52, 0x1p-30, 0x1p-10});
                said(apart == 0 ? "equal triangles" : "triangles one behind the other");
                const Point A = point(), B = point(), C = point();
                return times([&](int i) {
                    const Point by{0, 0, apart * i};
                    add(Triangle{A + by, B + by, C + by});
                });
            }
            case 7: {
                said("triangles about an edge");
                const Point A = point(), B = point();
                return times([&](int) { add(Triangle{A, B, point()}); });
            }
            case 8:
                said("spheres");
                return times([&](int) { add(Sphere{point(), 0.1 * random_.fraction() + 0.01}); });
            case 9: {
                said("spheres about a point");
                const Point middle = random_.one_in(2) ? Point{} : point();
                return times([&](int i) { add(Sphere{middle, 1.0 * (i + 1) / count}); });
            }
            case 10: {
                said("touching spheres");
                const int row = static_cast<int>(std::cbrt(count)) + 1;
                return times([&](int i) {
                    const Point at{1.0 * (i % row), 1.0 * (i / row % row), 1.0 * (i / row / row)};
                    add(Sphere{2.0 / row * at + Point{-1, -1, -1}, 1.0 / row});
                });
            }
            default:
                said("spheres of all sizes");
                return times([&](int) { add(Sphere{point(), random_.power_of_two(-30, 0)}); });
        }
    }

    void add_field(int count, double height) {
        const int cells = std::max(2, static_cast<int>(std::sqrt(count / 2)));
        const auto at = [&](int i, int j) {
            return Point{2.0 * i / cells - 1, 2.0 * j / cells - 1, height * std::sin(7.0 * i) * std::cos(5.0 * j)};
        };
        for (int i = 0; i < cells; ++i)
            for (int j = 0; j < cells; ++j) {
                add(Triangle{at(i, j), at(i + 1, j), at(i + 1, j + 1)});
                add(Triangle{at(i, j), at(i + 1, j + 1), at(i, j + 1)});
            }
    }

    template <class Change>
    void for_each_point(const Change& change) {
        for (auto& [c, r] : drawn_.surfaces.spheres) c = change(c);
        for (auto& [A, B, C] : drawn_.surfaces.triangles) {
            A = change(A);
            B = change(B);
            C = change(C);
        }
    }

    void round_to_few_bits() {
        const double unit = random_.power_of_two(2, 6);
        say("few bits");
        const auto round = [unit](double a) { return std::round(a * unit) / unit; };
        for_each_point([&](const Point& p) { return Point{round(p.x), round(p.y), round(p.z)}; });
        for (auto& [c, r] : drawn_.surfaces.spheres) r = std::max(round(r), 1 / unit);
    }

    void copy_all() {
        say("each twice");
        const auto twice = [](auto& list) {
            const std::size_t count = list.size();
            for (std::size_t i = 0; i < count; ++i) list.push_back(list[i]);
        };
        twice(drawn_.surfaces.spheres);
        twice(drawn_.surfaces.triangles);
    }

    /// One surface that is not like the others.
    void add_odd_one() {
        const double size = random_.of({10., 1e3, 1e5, 1e7, 1e10, 0x1p50, 0x1p70});
        switch (random_.below(4)) {
            case 0:
                say("a large triangle");
                return add(Triangle{{-size, -1.1, -size}, {size, -1.1, -size}, {0, -1.1, size}});
            case 1:
                say("a sphere around all");
                return add(Sphere{{0, 0, 0}, size});
            case 2:
                say("a sphere far away");
                return add(Sphere{{0, 0, -size}, 1});
            default:
                say("a triangle far away");
                return add(Triangle{{-1, -1, -size}, {1, -1, -size}, {0, 1, -size}});
        }
    }

    void choose_view() {
        if (random_.one_in(2)) {
            const double pixel = 2.0 / 64;  // 64 of them from −1 to 1, at points of few bits
            say("seen from above");
            drawn_.view = oracle::Parallel{{-1, -1, 4}, {pixel, 0, 0}, {0, pixel, 0}, {0, 0, -1}};
            return;
        }
        const Point eye = random_.of<Point>({{0, 0, 4}, {3, 2, 2.5}, {0, -4, 0}, {0, 0, 0.01}, point()});
        const Point look_at = random_.one_in(2) ? Point{} : 0.5 * point();
        drawn_.view = oracle::Pinhole{eye, look_at, {0.1, 0.9, 0.3}, 45};
        say("seen from a point");
    }

    /// Changes all points, and `change_length` the other lengths, of the view, too.
    template <class Change, class ChangeLength>
    void transform(const Change& change, const ChangeLength& change_length) {
        for_each_point(change);
        for (auto& [c, r] : drawn_.surfaces.spheres) r = change_length(r);
        if (auto* parallel = std::get_if<oracle::Parallel>(&drawn_.view)) {
            const auto vector = [&](const Point& v) {
                return Point{change_length(v.x), change_length(v.y), change_length(v.z)};
            };
            parallel->corner = change(parallel->corner);
            parallel->right = vector(parallel->right);
            parallel->up = vector(parallel->up);
        } else {
            auto& pinhole = std::get<oracle::Pinhole>(drawn_.view);
            pinhole.eye = change(pinhole.eye);
            pinhole.look_at = change(pinhole.look_at);
        }
    }

    void scale(double by) {
        say("scaled by 2^" + std::to_string(std::ilogb(by)));
        transform([by](const Point& p) { return by * p; }, [by](double length) { return by * length; });
    }

    void move(double by) {
        say("moved by 1e" + std::to_string(static_cast<int>(std::lround(std::log10(by)))));
        transform([by](const Point& p) { return p + Point{by, 0.5 * by, -by}; }, [](double length) { return length; });
    }

    Random random_;
    Drawn drawn_;
};

}  // namespace

Drawn draw_slow(std::uint64_t seed) { return SlowScene(seed)(); }

Drawn draw_ordinary(std::size_t spheres, std::size_t triangles, int side) {
    Random random(1);
    Drawn drawn;
    drawn.kind = "ordinary";
    drawn.width = drawn.height = side;
    drawn.view = oracle::Pinhole{{0, 0.3, 4}, {0, 0, 0}, {0, 1, 0}, 35};
    const auto point = [&] {
        const double x = 2 * random.fraction() - 1, y = 2 * random.fraction() - 1;
        return Point{x, y, 2 * random.fraction() - 1};
    };
    // As large as that together they cover the picture about once.
    const double size = 2 / std::sqrt(static_cast<double>(spheres + triangles));
    for (std::size_t i = 0; i < spheres; ++i) drawn.surfaces.spheres.push_back({point(), size / 2});
    for (std::size_t i = 0; i < triangles; ++i) {
        const Point A = point();
        const Point B = A + size * point();
        drawn.surfaces.triangles.push_back({A, B, A + size * point()});
    }
    return drawn;
}

}  // namespace glassbox::fuzz
