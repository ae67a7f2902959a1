#pragma once
#include <cstddef>
#include <optional>

#include <shading.hpp>
#include <sphere.hpp>
#include <triangle.hpp>

#include "numerics/recorded.hpp"

namespace glassbox {

/// The probe that gives recorded numbers the names that the formulas tell, and keeps them.
struct Heard {
    std::optional<Recorded> discriminant, t0, t1;
    std::optional<Recorded> a, b, c, sum, deficit;
    Recorded n_l, n_r, highlight, ambient, diffuse, specular;
    Vec3<Recorded> h;

    template <class What, class... Values>
    void operator()(What, const Values&...) {}

    void operator()(told::Discriminant, const Recorded& value) { keep(discriminant, value, "Δ"); }
    void operator()(told::Roots, const Recorded& smaller, const Recorded& larger) {
        keep(t0, smaller, "t₀");
        keep(t1, larger, "t₁");
    }
    void operator()(told::Corners, const Triangle<Recorded>& seen, const Vec3<Recorded>&) {
        name(seen.A, "(A − P)");
        name(seen.B, "(B − P)");
        name(seen.C, "(C − P)");
    }
    void operator()(told::Sides, const Recorded& side_a, const Recorded& side_b, const Recorded& side_c) {
        keep(a, side_a, "a");
        keep(b, side_b, "b");
        keep(c, side_c, "c");
    }
    void operator()(told::Deficit, const Recorded& its_sum, const Recorded& value) {
        keep(sum, its_sum, "a+b+c");
        keep(deficit, value, "| |a+b+c| − (|a|+|b|+|c|) |");
    }
    void operator()(told::NormalLight, const Recorded& value) { keep(n_l, value, "n·l"); }
    void operator()(told::NormalViewer, const Recorded& value) { keep(n_r, value, "n·r"); }
    void operator()(told::HalfVector, const Vec3<Recorded>& value) {
        name(value, "h");
        h = value;
    }
    void operator()(told::NormalHalf, const Recorded& value) { keep(highlight, value, "n·h"); }
    void operator()(told::Reflection, const Vec3<Recorded>& reflection, const Recorded& value) {
        name(reflection, "m");
        h = reflection;
        keep(highlight, value, "r·m");
    }
    void operator()(told::Ambient, const Recorded& value) { keep(ambient, value, "k_a"); }
    void operator()(told::DiffuseTerm, const Recorded& value) { keep(diffuse, value, "diffuse"); }
    void operator()(told::SpecularTerm, const Recorded& value) { keep(specular, value, "specular"); }

private:
    template <class Kept>
    static void keep(Kept& kept, const Recorded& value, const char* its_name) {
        name(value, its_name);
        kept = value;
    }
};

}  // namespace glassbox
