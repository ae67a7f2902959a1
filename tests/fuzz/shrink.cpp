#include "shrink.hpp"

#include <cmath>
#include <utility>

#include "scene/error.hpp"

namespace glassbox::fuzz {

namespace {

using oracle::Parallel, oracle::Pinhole, oracle::Point;

class Shrinker {
public:
    Shrinker(Drawn drawn, Fault fault, const Route& route) : best_{std::move(drawn), std::move(fault)}, route_(route) {}

    Shrunk operator()() {
        for (std::size_t before = 0; before != best_.drawn.surfaces.size() && tries_ > 0;) {
            before = best_.drawn.surfaces.size();
            keep_one_ray();
            keep_one_pixel();
            drop_surfaces();
        }
        shorten_numbers();
        return best_;
    }

private:
    /// Takes the scene as the best if the route fails there, too.
    bool take(Drawn drawn) {
        if (tries_ <= 0) return false;
        --tries_;
        try {
            const std::optional<Fault> fault = route_.check(Trial(drawn));
            if (!fault || fault->kind != best_.fault.kind) return false;
            best_ = {std::move(drawn), *fault};
            return true;
        } catch (const Error&) {
            return false;
        }
    }

    /// Removes surfaces, many at a time at first.
    void drop_surfaces() {
        for (std::size_t count = best_.drawn.surfaces.size() / 2; count > 0; count /= 2)
            for (std::size_t from = 0; from < best_.drawn.surfaces.size();) {
                if (!take(without(best_.drawn, from, from + count))) from += count;
            }
    }

    static Drawn without(Drawn drawn, std::size_t from, std::size_t to) {
        const std::size_t spheres = drawn.surfaces.spheres.size();
        const auto cut = [](auto& list, std::size_t begin, std::size_t end) {
            begin = std::min(begin, list.size());
            end = std::min(end, list.size());
            list.erase(list.begin() + static_cast<std::ptrdiff_t>(begin),
                       list.begin() + static_cast<std::ptrdiff_t>(end));
        };
        const auto after_spheres = [&](std::size_t n) { return n > spheres ? n - spheres : 0; };
        cut(drawn.surfaces.triangles, after_spheres(from), after_spheres(to));
        cut(drawn.surfaces.spheres, from, to);
        return drawn;
    }

    void keep_one_ray() {
        if (best_.drawn.rays.empty()) return;
        Drawn drawn = best_.drawn;
        if (best_.fault.ray && *best_.fault.ray < drawn.rays.size()) drawn.rays = {drawn.rays[*best_.fault.ray]};
        else drawn.rays.clear();
        if (drawn.rays.size() < best_.drawn.rays.size()) take(std::move(drawn));
    }

    /// Reduces the picture to one pixel, or halves it again and again.
    void keep_one_pixel() {
        if (best_.fault.ray) {
            if (!take(one_pixel({}))) halve();
            return;
        }
        if (!best_.fault.pixel || (best_.drawn.width == 1 && best_.drawn.height == 1)) return;
        const Ray<double> ray = Trial(best_.drawn).pixel_rays()[*best_.fault.pixel];
        Drawn drawn = one_pixel(to_oracle(ray));
        if (take(drawn)) return;
        drawn.view = Parallel{to_oracle(ray).P, {0, 1, 0}, {0, 0, 1}, to_oracle(ray).D};
        if (!take(std::move(drawn))) halve();
    }

    Drawn one_pixel(const oracle::Ray& ray) const {
        Drawn drawn = best_.drawn;
        drawn.width = drawn.height = 1;
        if (auto* parallel = std::get_if<Parallel>(&drawn.view)) parallel->corner = ray.P;
        else std::get<Pinhole>(drawn.view).look_at = plus(ray.P, 1, ray.D);
        return drawn;
    }

    void halve() {
        for (int more = 12; more > 0; --more) {
            if (best_.drawn.width > 1 && (take(cropped(0.5, 1, 0, 0)) || take(cropped(0.5, 1, 0.5, 0)))) continue;
            if (best_.drawn.height > 1 && (take(cropped(1, 0.5, 0, 0)) || take(cropped(1, 0.5, 0, 0.5)))) continue;
            return;
        }
    }

    /// A part of a parallel view's picture, starting that far to the right and upwards; of a pinhole's, its middle.
    Drawn cropped(double width, double height, double right, double up) const {
        Drawn drawn = best_.drawn;
        const double j = std::ceil(drawn.width * right), i = std::ceil(drawn.height * up);
        drawn.width = std::max(1, static_cast<int>(drawn.width * width));
        drawn.height = std::max(1, static_cast<int>(drawn.height * height));
        if (auto* v = std::get_if<Parallel>(&drawn.view)) v->corner = plus(plus(v->corner, j, v->right), i, v->up);
        return drawn;
    }

    static Point plus(const Point& a, double s, const Point& b) {
        return {a.x + s * b.x, a.y + s * b.y, a.z + s * b.z};
    }

    /// Calls `use` with each number of a scene.
    template <class Use>
    static void for_each_number(Drawn& drawn, const Use& use) {
        const auto point = [&](Point& p) {
            use(p.x);
            use(p.y);
            use(p.z);
        };
        for (auto& [c, r] : drawn.surfaces.spheres) {
            point(c);
            use(r);
        }
        for (auto& [A, B, C] : drawn.surfaces.triangles) {
            point(A);
            point(B);
            point(C);
        }
        if (auto* v = std::get_if<Parallel>(&drawn.view)) {
            point(v->corner);
            point(v->direction);
        } else {
            point(std::get<Pinhole>(drawn.view).eye);
            point(std::get<Pinhole>(drawn.view).look_at);
        }
        for (auto& [P, D] : drawn.rays) {
            point(P);
            point(D);
        }
    }

    static double shortened(double x, int bits) {
        if (x == 0 || !std::isfinite(x)) return x;
        if (bits == 0) return 0;
        const int exponent = std::ilogb(x) + 1 - bits;
        return std::ldexp(std::round(std::ldexp(x, -exponent)), exponent);
    }

    void shorten_numbers() {
        std::size_t count = 0;
        for_each_number(best_.drawn, [&](double&) { ++count; });
        for (std::size_t n = 0; n < count; ++n)
            for (const int bits : {0, 1, 3, 6, 12, 24, 36}) {
                Drawn drawn = best_.drawn;
                std::size_t at = 0;
                bool changed = false;
                for_each_number(drawn, [&](double& x) {
                    if (at++ != n) return;
                    changed = shortened(x, bits) != x;
                    x = shortened(x, bits);
                });
                if (!changed || take(std::move(drawn))) break;
            }
    }

    Shrunk best_;
    const Route& route_;
    int tries_ = 1500;
};

}  // namespace

Shrunk shrink(const Drawn& drawn, const Fault& fault, const Route& route) { return Shrinker(drawn, fault, route)(); }

}  // namespace glassbox::fuzz
