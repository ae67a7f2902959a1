// The engine against the plain certified loop: for every ray the same verdict, surface, t and number of hits.
#include <doctest.h>

#include <algorithm>
#include <cmath>
#include <sstream>

#include "../certified/cases.hpp"
#include "numerics/exact.hpp"
#include "render/search/build_engine.hpp"
#include "render/search/exact_crossing.hpp"
#include "render/search/fast_search.hpp"
#include "render/shoot.hpp"

using namespace glassbox;
using test::Case;

namespace {

using Verdict = Shot::Answer;

Options by(EngineChoice engine) {
    Options options;
    options.engine = engine;
    return options;
}

std::string shown(const Ray<double>& ray) {
    std::ostringstream out;
    out << std::hexfloat << ray.P.x << "," << ray.P.y << "," << ray.P.z << "," << ray.D.x << "," << ray.D.y << ","
        << ray.D.z;
    return out.str();
}

std::string shown(const Shot& shot) {
    std::ostringstream out;
    out.precision(21);
    out << (shot.answer == Verdict::hit    ? "hit of "
            : shot.answer == Verdict::miss ? "miss "
                                           : "invalid ")
        << shot.surface << " at " << shot.t << " ± " << shot.t_error << ", meets " << shot.hits;
    return out.str();
}

bool same(const Shot& one, const Shot& other) {
    return one.answer == other.answer && one.surface == other.surface && one.t == other.t && one.hits == other.hits &&
           one.t_error == other.t_error;
}

/// t of a surface that is met.
Exact true_t(const engine::Engine& engine, const Ray<double>& ray, std::size_t surface) {
    return engine.with_surface(surface, [&]<class Surface>(const Surface& s) {
        if constexpr (std::is_same_v<Surface, Sphere<double>>) return exact_crossing(ray, s, Stable{})->exact();
        else return exact_crossing(ray, s, Pluecker{})->exact();
    });
}

/// Whether t lies between these two.
bool between(const FastSearch::Nearest& bounds, const Exact& t) {
    return (!std::isfinite(bounds.low) || compare(Exact(bounds.low), t) <= 0) &&
           (!std::isfinite(bounds.high) || compare(t, Exact(bounds.high)) <= 0);
}

/// Returns for how many rays the engine's answer differs.
int differences(const Case& c) {
    int count = 0;
    const auto differs = [&](const Ray<double>& ray, const std::string& expected, const std::string& got) {
        if (++count <= 3)
            MESSAGE(c.name << "\n  ray      " << shown(ray) << "\n  expected " << expected << "\n  got      " << got);
    };
    const std::vector<Shot> plain = shoot(c.scene, by(EngineChoice::plain), c.rays, {1, {}, nullptr});
    const std::vector<Shot> fast = shoot(c.scene, by(EngineChoice::fast), c.rays, {1, {}, nullptr});
    const FastSearch nearest_only(build_engine(c.scene, 5, 1), {}, {});
    const Silent silent;
    for (std::size_t i = 0; i < c.rays.size(); ++i) {
        const Ray<double>& ray = c.rays[i];
        if (!same(plain[i], fast[i])) differs(ray, shown(plain[i]), shown(fast[i]));
        // The engine must not need exact arithmetic where bounds decide in the plain loop.
        if (plain[i].by_filter && !fast[i].by_filter) differs(ray, "decided by bounds", "decided exactly");
        const auto hit = nearest_only.trace(ray, silent);
        if (hit.has_value() != (plain[i].answer == Verdict::hit)) differs(ray, shown(plain[i]), hit ? "hit" : "miss");
        else if (hit && hit->surface != plain[i].surface)
            differs(ray, shown(plain[i]), "hit of " + std::to_string(hit->surface));
        if (plain[i].answer == Verdict::invalid) continue;
        const auto nearest = nearest_only.nearest(ray);
        if (nearest.has_value() != hit.has_value() || (nearest && nearest->surface != plain[i].surface))
            differs(ray, shown(plain[i]), nearest ? "nearest " + std::to_string(nearest->surface) : "nothing nearest");
        else if (nearest && !between(*nearest, true_t(nearest_only.engine(), ray, nearest->surface)))
            differs(ray, shown(plain[i]), "another t for the nearest");
        if (nearest_only.occluded(ray) != (plain[i].answer == Verdict::hit))
            differs(ray, shown(plain[i]), hit ? "not occluded" : "occluded");
    }
    return count;
}

/// The plain loop is slow, and there are many cases: tests only one ray in `step`.
int differences(std::vector<Case> cases, std::size_t step) {
    int count = 0;
    for (Case& c : cases) {
        std::size_t kept = 0;
        for (std::size_t i = 0; i < c.rays.size(); i += step) c.rays[kept++] = c.rays[i];
        c.rays.resize(kept);
        count += differences(c);
    }
    return count;
}

}  // namespace

TEST_CASE("through vertices and edges of meshes, at all scales and distances from the origin") {
    CHECK(differences(test::meshes(), 7) == 0);
}
TEST_CASE("starts one ulp apart") { CHECK(differences(test::grids(), 3) == 0); }
TEST_CASE("surfaces at the same distance") { CHECK(differences(test::ties(), 3) == 0); }
TEST_CASE("triangles of nearly no area") { CHECK(differences(test::slivers(), 3) == 0); }
TEST_CASE("spheres, far, grazed, huge and tiny") { CHECK(differences(test::spheres(), 3) == 0); }
TEST_CASE("sizes whose products overflow and underflow") { CHECK(differences(test::magnitudes(), 3) == 0); }
TEST_CASE("all sizes at once") { CHECK(differences({test::all_sizes()}, 1) == 0); }
TEST_CASE("nothing special") { CHECK(differences({test::anything()}, 7) == 0); }

TEST_CASE("a scene without surfaces") {
    Case c{"empty", {}, {{{0, 0, 0}, {1, 0, 0}}, {{0, 0, 0}, {0, 0, 0}}}};
    CHECK(differences(c) == 0);
}

TEST_CASE("rays along the axes, in the faces of boxes and past them") {
    // The box of each triangle has the faces x, y, z = whole numbers, and the rays run in these very faces.
    Case c{"a grid of triangles", {}, {}};
    for (int i = 0; i < 8; ++i)
        for (int j = 0; j < 8; ++j)
            c.scene.triangles.push_back(
                {{Vec3<double>{1.0 * i, 1.0 * j, 0}, {i + 1.0, 1.0 * j, 0}, {1.0 * i, j + 1.0, (i + j) % 3 * 1.0}},
                 {}});
    for (int axis = 0; axis < 3; ++axis)
        for (const double sign : {1.0, -1.0})
            for (int i = -1; i <= 17; ++i)
                for (int j = -1; j <= 17; ++j) {
                    double P[3], D[3] = {0, -0.0, 0};
                    P[axis] = -sign * 20;
                    P[(axis + 1) % 3] = i * 0.5;
                    P[(axis + 2) % 3] = j * 0.5;
                    D[axis] = sign;
                    c.rays.push_back({{P[0], P[1], P[2]}, {D[0], D[1], D[2]}});
                    D[(axis + 1) % 3] = 0x1p-70;  // almost 0
                    c.rays.push_back({{P[0], P[1], P[2]}, {D[0], D[1], D[2]}});
                }
    CHECK(differences(c) == 0);
}
