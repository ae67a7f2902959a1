#pragma once
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

#include <shading.hpp>
#include <sphere.hpp>
#include <triangle.hpp>

#include "numerics/magnitude.hpp"
#include "render/plane.hpp"
#include "render/tracer.hpp"

namespace glassbox {

/// The probe behind `measure`: keeps the numbers of one pixel as the formulas tell them; `no_value` for those that
/// were not reached.
struct PixelNumbers {
    double tests = 0;     ///< surfaces tested
    double hits = 0;      ///< surfaces met
    double t = no_value;  ///< of the nearest
    std::array<double, 3> normal{no_value, no_value, no_value};
    double n_l = no_value, n_h = no_value, n_v = no_value;
    double ambient = no_value, diffuse = no_value, specular = no_value;
    double discriminant = no_value;  ///< the largest of all spheres tested
    double side = no_value;          ///< the smallest side product of all triangles tested, over its terms' sizes

    template <class What, class... Values>
    void operator()(What, const Values&...) {}

    void operator()(told::Tested) { ++tests; }

    template <class Real>
    void operator()(told::Met, std::size_t, const Real&) {
        ++hits;
    }

    template <class Real>
    void operator()(told::Nearest, std::size_t, const Real& nearest_t) {
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
        n_v = static_cast<double>(value);
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
        discriminant = std::fmax(discriminant, static_cast<double>(value));  // fmax passes over not a number
    }

    template <class Real>
    void operator()(told::Corners, const Triangle<Real>& seen, const Vec3<Real>& D) {
        side_sizes = glassbox::sides(convert<Magnitude>(D), convert<Magnitude>(seen));
    }

    template <class Real>
    void operator()(told::Sides, const Real& a, const Real& b, const Real& c) {
        keep_side(static_cast<double>(a), side_sizes.a.size);
        keep_side(static_cast<double>(b), side_sizes.b.size);
        keep_side(static_cast<double>(c), side_sizes.c.size);
    }

private:
    Sides<Magnitude> side_sizes;
    double smallest_side = std::numeric_limits<double>::infinity();

    void keep_side(double s, double size) {
        if (!(std::abs(s) < smallest_side)) return;
        smallest_side = std::abs(s);
        side = size > 0 ? s / size : 0;
    }
};

}  // namespace glassbox
