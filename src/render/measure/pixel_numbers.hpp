#pragma once
#include <array>
#include <cstddef>
#include <optional>
#include <type_traits>

#include <shade_told.hpp>

#include "render/measure/channel.hpp"
#include "render/measure/triangle_numbers.hpp"
#include "render/search/certified_search.hpp"
#include "render/search/fast_search.hpp"
#include "render/tracer_told.hpp"

namespace glassbox {

/// The counting probe behind `measure`: keeps the numbers of one pixel as the formulas report them; `no_value` for
/// those not reached. Measuring side products costs several times as much as the tests themselves: WithTriangles does
/// it.
struct PixelNumbers {
    static constexpr bool only_nearest = true;

    double tests = 0;     ///< surfaces tested
    double hits = 0;      ///< surfaces met
    double t = no_value;  ///< of the nearest
    std::array<double, 3> normal{no_value, no_value, no_value};
    double n_l = no_value, n_h = no_value, n_r = no_value;
    double ambient = no_value, diffuse = no_value, specular = no_value;
    double discriminant = no_value;  ///< the largest of all tested spheres'
    bool sphere_tested = false;      ///< at least one
    TriangleNumbers triangles;
    int exact_tests = 0;                 ///< surfaces that needed exact arithmetic
    double undecided = no_value;         ///< the same, if the search proves its answers
    double verdict = no_value;           ///< 0 right, 1 wrong hit, 2 wrong miss, 3 wrong surface
    double bits_lost = no_value;         ///< of t, where the surface is right
    double drift = no_value;             ///< of the ray's start
    double nodes = no_value;             ///< nodes of the hierarchy visited
    double boxes_missed = no_value;      ///< boxes in them, missed
    std::optional<std::size_t> surface;  ///< the nearest
    long double found_t = no_value;      ///< its t, wide enough for every scalar

    template <class What, class... Values>
    void operator()(What, const Values&...) {}

    void operator()(told::Tested) { ++tests; }

    template <class Real>
    void operator()(told::Met, std::size_t, const Real&) {
        ++hits;
    }

    template <class Real>
    void operator()(told::Nearest, std::size_t nearest, const Real& nearest_t) {
        surface = nearest;
        found_t = nearest_t;
        t = static_cast<double>(nearest_t);
    }

    template <class Real>
    void operator()(told::SurfaceNormal, const Vec3<Real>& n) {
        const Vec3<double> kept = convert<double>(n);
        normal = {kept.x, kept.y, kept.z};
    }

    template <class Real>
    void operator()(told::NormalLight, const Real& value) {
        n_l = static_cast<double>(value);
    }

    template <class Real>
    void operator()(told::NormalHalf, const Real& value) {
        n_h = static_cast<double>(value);
    }

    template <class Real>
    void operator()(told::NormalViewer, const Real& value) {
        n_r = static_cast<double>(value);
    }

    template <class Real>
    void operator()(told::Ambient, const Real& value) {
        ambient = static_cast<double>(value);
    }

    template <class Real>
    void operator()(told::DiffuseTerm, const Real& value) {
        diffuse = static_cast<double>(value);
    }

    template <class Real>
    void operator()(told::SpecularTerm, const Real& value) {
        specular = static_cast<double>(value);
    }

    template <class Real>
    void operator()(told::Discriminant, const Real& value) {
        sphere_tested = true;
        const double now = static_cast<double>(value);
        if (now > discriminant || discriminant != discriminant) discriminant = now;  // ignores NaN
    }

    void operator()(told::Undecided, std::size_t) { ++exact_tests; }

    void operator()(told::NodesVisited, std::uint64_t count) { nodes = static_cast<double>(count); }
    void operator()(told::BoxesMissed, std::uint64_t count) { boxes_missed = static_cast<double>(count); }
};

/// The same probe with its `triangles` filled in.
struct WithTriangles {
    static constexpr bool only_nearest = true;

    PixelNumbers numbers;

    template <class What, class... Values>
    void operator()(What what, const Values&... values) {
        if constexpr (std::is_same_v<What, told::Corners>) numbers.triangles.take(values...);
        else numbers(what, values...);
    }
};

}  // namespace glassbox
