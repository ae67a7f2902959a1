#pragma once
#include <optional>

#include <intersect_sphere.hpp>
#include <shade_told.hpp>
#include <tolerance.hpp>

#include "numerics/recorded.hpp"

namespace glassbox {

/// The probe that names recorded numbers as the formulas report them, and keeps them.
template <class Real>
struct NamingProbe {
    using Number = Recorded<Real>;

    std::optional<Number> discriminant, t0, t1;
    std::optional<Number> a, b, c, sum, deficit;
    Number n_l, n_r, highlight, ambient, diffuse, specular;
    Vec3<Number> h;

    template <class What, class... Values>
    void operator()(What, const Values&...) {}

    void operator()(told::Discriminant, const Number& value) { keep(discriminant, value, "Δ"); }
    void operator()(told::Roots, const Number& smaller, const Number& larger) {
        keep(t0, smaller, "t₀");
        keep(t1, larger, "t₁");
    }
    void operator()(told::Corners, const Triangle<Number>& seen, const Vec3<Number>&) {
        name(seen.A, "(A − P)");
        name(seen.B, "(B − P)");
        name(seen.C, "(C − P)");
    }
    void operator()(told::Sides, const Number& side_a, const Number& side_b, const Number& side_c) {
        keep(a, side_a, "a");
        keep(b, side_b, "b");
        keep(c, side_c, "c");
    }
    void operator()(told::Deficit, const Number& its_sum, const Number& value) {
        keep(sum, its_sum, "a+b+c");
        keep(deficit, value, "| |a+b+c| − (|a|+|b|+|c|) |");
    }
    void operator()(told::NormalLight, const Number& value) { keep(n_l, value, "n·l"); }
    void operator()(told::NormalViewer, const Number& value) { keep(n_r, value, "n·r"); }
    void operator()(told::HalfVector, const Vec3<Number>& value) {
        name(value, "h");
        h = value;
    }
    void operator()(told::NormalHalf, const Number& value) { keep(highlight, value, "n·h"); }
    void operator()(told::Reflection, const Vec3<Number>& reflection, const Number& value) {
        name(reflection, "m");
        h = reflection;
        keep(highlight, value, "r·m");
    }
    void operator()(told::Ambient, const Number& value) { keep(ambient, value, "k_a"); }
    void operator()(told::DiffuseTerm, const Number& value) { keep(diffuse, value, "diffuse"); }
    void operator()(told::SpecularTerm, const Number& value) { keep(specular, value, "specular"); }

private:
    template <class Kept>
    static void keep(Kept& kept, const Number& value, const char* its_name) {
        name(value, its_name);
        kept = value;
    }
};

}  // namespace glassbox
