#pragma once
#include <concepts>

#include <ray_color.hpp>
#include <shade_by_model.hpp>
#include <tolerance.hpp>

#include <levental_2014.hpp>
#include <moeller_trumbore.hpp>

#include "numerics/tape.hpp"

// The calls of a recorded computation. A header of the core calls its functions by their plain names; for recorded
// numbers these overloads are the better match. Each knows the line that called it, notes the call on the tape, and
// calls the core's own function, which does the work. Operators of vectors cannot know that line.
namespace glassbox {

template <class Real>
class Recorded;

template <class Real>
Tape* tape_of(const Recorded<Real>& number) {
    return number.tape();
}
template <class Real>
Tape* tape_of(const Vec3<Recorded<Real>>& v) {
    return v.x.tape() ? v.x.tape() : v.y.tape() ? v.y.tape() : v.z.tape();
}
/// The tape of the first number that has one; null if all are constants.
template <class First, class... More>
requires(sizeof...(More) > 0) Tape* tape_of(const First& first, const More&... more) {
    Tape* const tape = tape_of(first);
    return tape ? tape : tape_of(more...);
}

/// Notes a call on a tape, if there is one, as long as it lives.
class Calling {
public:
    Calling(Tape* tape, const Call& call) : tape_(tape) {
        if (tape_) tape_->enter(call);
    }
    ~Calling() {
        if (tape_) tape_->leave();
    }
    Calling(const Calling&) = delete;
    Calling& operator=(const Calling&) = delete;

private:
    Tape* tape_;
};

/// Where a rule stands, and its name.
template <class Rule>
constexpr Call call_of_rule(const char* file, int line) {
    if constexpr (std::same_as<Rule, Stable>) return {"intersect_sphere.hpp", "Stable", file, line};
    else if constexpr (std::same_as<Rule, Textbook>) return {"intersect_sphere.hpp", "Textbook", file, line};
    else if constexpr (std::same_as<Rule, Levental2014>) return {"levental_2014.hpp", "Levental2014", file, line};
    else if constexpr (std::same_as<Rule, Pluecker>) return {"intersect_triangle.hpp", "Pluecker", file, line};
    else if constexpr (std::same_as<Rule, Tolerance>) return {"tolerance.hpp", "Tolerance", file, line};
    else if constexpr (std::same_as<Rule, MoellerTrumbore>)
        return {"moeller_trumbore.hpp", "MoellerTrumbore", file, line};
    else return {"", "", file, line};
}

/// A rule whose calls are noted.
template <class Rule>
struct Followed {
    const Rule& rule;

    template <class Real, class Surface, class Probe>
    auto operator()(const Ray<Recorded<Real>>& ray, const Surface& surface, Probe& probe,
                    const char* file = __builtin_FILE(), int line = __builtin_LINE()) const {
        const Calling here(tape_of(ray.P, ray.D), call_of_rule<Rule>(file, line));
        return rule(ray, surface, probe);
    }
};

template <std::floating_point Real, class Rule, class Probe>
auto intersect(const Ray<Recorded<Real>>& ray, const Sphere<Recorded<Real>>& sphere, const Rule& rule, Probe& probe,
               const char* file = __builtin_FILE(), int line = __builtin_LINE()) {
    const Calling here(tape_of(ray.P, ray.D), {"intersect_sphere.hpp", "intersect", file, line});
    return intersect<Recorded<Real>>(ray, sphere, Followed<Rule>{rule}, probe);
}
template <std::floating_point Real, class Rule, class Probe>
auto intersect(const Ray<Recorded<Real>>& ray, const Triangle<Recorded<Real>>& triangle, const Rule& rule, Probe& probe,
               const char* file = __builtin_FILE(), int line = __builtin_LINE()) {
    const Calling here(tape_of(ray.P, ray.D), {"intersect_triangle.hpp", "intersect", file, line});
    return intersect<Recorded<Real>>(ray, triangle, Followed<Rule>{rule}, probe);
}
template <class Rule, std::floating_point Real, class Probe>
auto roots_by(const Rule& rule, const Ray<Recorded<Real>>& ray, const Sphere<Recorded<Real>>& sphere, Probe& probe,
              const char* file = __builtin_FILE(), int line = __builtin_LINE()) {
    return Followed<Rule>{rule}(ray, sphere, probe, file, line);
}
template <std::floating_point Real>
auto dot(const Vec3<Recorded<Real>>& a, const Vec3<Recorded<Real>>& b, const char* file = __builtin_FILE(),
         int line = __builtin_LINE()) {
    const Calling here(tape_of(a, b), {"vec3.hpp", "dot", file, line});
    return dot<Recorded<Real>>(a, b);
}
template <std::floating_point Real>
auto cross(const Vec3<Recorded<Real>>& a, const Vec3<Recorded<Real>>& b, const char* file = __builtin_FILE(),
           int line = __builtin_LINE()) {
    const Calling here(tape_of(a, b), {"vec3.hpp", "cross", file, line});
    return cross<Recorded<Real>>(a, b);
}
template <std::floating_point Real>
auto length(const Vec3<Recorded<Real>>& a, const char* file = __builtin_FILE(), int line = __builtin_LINE()) {
    const Calling here(tape_of(a), {"vec3.hpp", "length", file, line});
    return length<Recorded<Real>>(a);
}
template <std::floating_point Real>
auto unit(const Vec3<Recorded<Real>>& a, const char* file = __builtin_FILE(), int line = __builtin_LINE()) {
    const Calling here(tape_of(a), {"vec3.hpp", "unit", file, line});
    return unit<Recorded<Real>>(a);
}
template <std::floating_point Real>
auto at(const Ray<Recorded<Real>>& ray, const Recorded<Real>& t, const char* file = __builtin_FILE(),
        int line = __builtin_LINE()) {
    const Calling here(tape_of(ray.P), {"ray.hpp", "at", file, line});
    return at<Recorded<Real>>(ray, t);
}
template <std::floating_point Real>
auto ray_color(const Ray<Recorded<Real>>& ray, int j, int i, const char* file = __builtin_FILE(),
               int line = __builtin_LINE()) {
    const Calling here(tape_of(ray.D), {"ray_color.hpp", "ray_color", file, line});
    return ray_color<Recorded<Real>>(ray, j, i);
}
template <std::floating_point Real>
auto quadratic(const Ray<Recorded<Real>>& ray, const Sphere<Recorded<Real>>& sphere,
               const char* file = __builtin_FILE(), int line = __builtin_LINE()) {
    const Calling here(tape_of(ray.P, sphere.C), {"quadratic.hpp", "quadratic", file, line});
    return quadratic<Recorded<Real>>(ray, sphere);
}
template <std::floating_point Real>
auto discriminant(const Quadratic<Recorded<Real>>& equation, const char* file = __builtin_FILE(),
                  int line = __builtin_LINE()) {
    const Calling here(tape_of(equation.a, equation.b, equation.c), {"quadratic.hpp", "discriminant", file, line});
    return discriminant<Recorded<Real>>(equation);
}
template <std::floating_point Real>
auto roots(const Quadratic<Recorded<Real>>& equation, const Recorded<Real>& root_of_discriminant,
           const char* file = __builtin_FILE(), int line = __builtin_LINE()) {
    const Calling here(tape_of(root_of_discriminant, equation.a), {"quadratic.hpp", "roots", file, line});
    return roots<Recorded<Real>>(equation, root_of_discriminant);
}
template <std::floating_point Real>
auto chord(const Ray<Recorded<Real>>& ray, const Sphere<Recorded<Real>>& sphere, const char* file = __builtin_FILE(),
           int line = __builtin_LINE()) {
    const Calling here(tape_of(ray.P, sphere.C), {"chord.hpp", "chord", file, line});
    return chord<Recorded<Real>>(ray, sphere);
}
template <std::floating_point Real>
auto discriminant(const Chord<Recorded<Real>>& chord, const Recorded<Real>& r, const char* file = __builtin_FILE(),
                  int line = __builtin_LINE()) {
    const Calling here(tape_of(chord.a, r), {"chord.hpp", "discriminant", file, line});
    return discriminant<Recorded<Real>>(chord, r);
}
template <std::floating_point Real>
auto first_ahead(const Recorded<Real>& t0, const Recorded<Real>& t1, const char* file = __builtin_FILE(),
                 int line = __builtin_LINE()) {
    const Calling here(tape_of(t0, t1), {"crossing.hpp", "first_ahead", file, line});
    return first_ahead<Recorded<Real>>(t0, t1);
}
template <std::floating_point Real>
auto normal(const Sphere<Recorded<Real>>& sphere, const Vec3<Recorded<Real>>& X, const char* file = __builtin_FILE(),
            int line = __builtin_LINE()) {
    const Calling here(tape_of(X, sphere.C), {"sphere.hpp", "normal", file, line});
    return normal<Recorded<Real>>(sphere, X);
}
template <std::floating_point Real>
auto side(const Vec3<Recorded<Real>>& D, const Vec3<Recorded<Real>>& A, const Vec3<Recorded<Real>>& B,
          const char* file = __builtin_FILE(), int line = __builtin_LINE()) {
    const Calling here(tape_of(D, A, B), {"pluecker.hpp", "side", file, line});
    return side<Recorded<Real>>(D, A, B);
}
template <std::floating_point Real>
auto seen_from(const Vec3<Recorded<Real>>& P, const Triangle<Recorded<Real>>& triangle,
               const char* file = __builtin_FILE(), int line = __builtin_LINE()) {
    const Calling here(tape_of(P, triangle.A), {"sides.hpp", "seen_from", file, line});
    return seen_from<Recorded<Real>>(P, triangle);
}
template <std::floating_point Real>
auto sides(const Vec3<Recorded<Real>>& D, const Triangle<Recorded<Real>>& triangle, const char* file = __builtin_FILE(),
           int line = __builtin_LINE()) {
    const Calling here(tape_of(D, triangle.A), {"sides.hpp", "sides", file, line});
    return sides<Recorded<Real>>(D, triangle);
}
template <std::floating_point Real>
auto inside(const Sides<Recorded<Real>>& sides, const char* file = __builtin_FILE(), int line = __builtin_LINE()) {
    const Calling here(tape_of(sides.a, sides.b, sides.c), {"sides.hpp", "inside", file, line});
    return inside<Recorded<Real>>(sides);
}
template <std::floating_point Real>
auto plane_t(const Vec3<Recorded<Real>>& D, const Triangle<Recorded<Real>>& triangle,
             const Sides<Recorded<Real>>& weights, const char* file = __builtin_FILE(), int line = __builtin_LINE()) {
    const Calling here(tape_of(D, weights.a), {"sides.hpp", "plane_t", file, line});
    return plane_t<Recorded<Real>>(D, triangle, weights);
}
template <std::floating_point Real, class IsInside, class Probe>
auto by_sides(const Ray<Recorded<Real>>& ray, const Triangle<Recorded<Real>>& triangle, const IsInside& is_inside,
              Probe& probe, const char* file = __builtin_FILE(), int line = __builtin_LINE()) {
    const Calling here(tape_of(ray.P), {"intersect_triangle.hpp", "by_sides", file, line});
    return by_sides<Recorded<Real>>(ray, triangle, is_inside, probe);
}
template <std::floating_point Real, class Probe>
auto accepts(const Tolerance& rule, const Sides<Recorded<Real>>& sides, Probe& probe,
             const char* file = __builtin_FILE(), int line = __builtin_LINE()) {
    const Calling here(tape_of(sides.a, sides.b, sides.c), {"tolerance.hpp", "accepts", file, line});
    return accepts<Recorded<Real>>(rule, sides, probe);
}
template <std::floating_point Real>
auto normal(const Triangle<Recorded<Real>>& triangle, const char* file = __builtin_FILE(),
            int line = __builtin_LINE()) {
    const Calling here(tape_of(triangle.A, triangle.B, triangle.C), {"triangle.hpp", "normal", file, line});
    return normal<Recorded<Real>>(triangle);
}
template <std::floating_point Real>
auto directional_light(const Vec3<Recorded<Real>>& L, const Recorded<Real>& intensity,
                       const char* file = __builtin_FILE(), int line = __builtin_LINE()) {
    const Calling here(tape_of(L), {"light.hpp", "directional_light", file, line});
    return directional_light<Recorded<Real>>(L, intensity);
}
template <std::floating_point Real>
auto positive_part(const Recorded<Real>& x, const char* file = __builtin_FILE(), int line = __builtin_LINE()) {
    const Calling here(tape_of(x), {"reflection.hpp", "positive_part", file, line});
    return positive_part<Recorded<Real>>(x);
}
template <std::floating_point Real>
auto towards(const Vec3<Recorded<Real>>& r, const Vec3<Recorded<Real>>& n, const char* file = __builtin_FILE(),
             int line = __builtin_LINE()) {
    const Calling here(tape_of(r, n), {"reflection.hpp", "towards", file, line});
    return towards<Recorded<Real>>(r, n);
}
template <std::floating_point Real>
auto diffuse(const Recorded<Real>& I, const Recorded<Real>& k_d, const Recorded<Real>& n_l,
             const char* file = __builtin_FILE(), int line = __builtin_LINE()) {
    const Calling here(tape_of(I, k_d, n_l), {"reflection.hpp", "diffuse", file, line});
    return diffuse<Recorded<Real>>(I, k_d, n_l);
}
template <std::floating_point Real>
auto halfway(const Vec3<Recorded<Real>>& a, const Vec3<Recorded<Real>>& b, const char* file = __builtin_FILE(),
             int line = __builtin_LINE()) {
    const Calling here(tape_of(a, b), {"reflection.hpp", "halfway", file, line});
    return halfway<Recorded<Real>>(a, b);
}
template <std::floating_point Real>
auto reflected(const Vec3<Recorded<Real>>& l, const Vec3<Recorded<Real>>& n, const char* file = __builtin_FILE(),
               int line = __builtin_LINE()) {
    const Calling here(tape_of(l, n), {"reflection.hpp", "reflected", file, line});
    return reflected<Recorded<Real>>(l, n);
}
template <std::floating_point Real>
auto specular(const Recorded<Real>& I, const Recorded<Real>& k_s, const Recorded<Real>& cosine, const Recorded<Real>& e,
              const char* file = __builtin_FILE(), int line = __builtin_LINE()) {
    const Calling here(tape_of(I, k_s, cosine), {"reflection.hpp", "specular", file, line});
    return specular<Recorded<Real>>(I, k_s, cosine, e);
}
template <std::floating_point Real>
auto truncated_byte(const Recorded<Real>& value, const char* file = __builtin_FILE(), int line = __builtin_LINE()) {
    const Calling here(tape_of(value), {"rgb.hpp", "truncated_byte", file, line});
    return truncated_byte<Recorded<Real>>(value);
}
template <std::floating_point Real>
auto rounded_byte(const Recorded<Real>& value, const char* file = __builtin_FILE(), int line = __builtin_LINE()) {
    const Calling here(tape_of(value), {"rgb.hpp", "rounded_byte", file, line});
    return rounded_byte<Recorded<Real>>(value);
}
template <std::floating_point Real>
auto rounded(const Vec3<Recorded<Real>>& color, const char* file = __builtin_FILE(), int line = __builtin_LINE()) {
    const Calling here(tape_of(color), {"rgb.hpp", "rounded", file, line});
    return rounded<Recorded<Real>>(color);
}
template <std::floating_point Real>
auto truncated(const Vec3<Recorded<Real>>& color, const char* file = __builtin_FILE(), int line = __builtin_LINE()) {
    const Calling here(tape_of(color), {"rgb.hpp", "truncated", file, line});
    return truncated<Recorded<Real>>(color);
}
template <std::floating_point Real>
auto tinted(const Recorded<Real>& strength, const Vec3<Recorded<Real>>& color, const char* file = __builtin_FILE(),
            int line = __builtin_LINE()) {
    const Calling here(tape_of(strength, color), {"rgb.hpp", "tinted", file, line});
    return tinted<Recorded<Real>>(strength, color);
}
template <std::floating_point Real, class Probe>
auto highlight_blinn(const Vec3<Recorded<Real>>& n, const Vec3<Recorded<Real>>& l, const Vec3<Recorded<Real>>& r,
                     Probe& probe, const char* file = __builtin_FILE(), int line = __builtin_LINE()) {
    const Calling here(tape_of(n, l), {"shade.hpp", "highlight_blinn", file, line});
    return highlight_blinn<Recorded<Real>>(n, l, r, probe);
}
template <std::floating_point Real, class Probe>
auto highlight_phong(const Vec3<Recorded<Real>>& n, const Vec3<Recorded<Real>>& l, const Vec3<Recorded<Real>>& r,
                     Probe& probe, const char* file = __builtin_FILE(), int line = __builtin_LINE()) {
    const Calling here(tape_of(n, l), {"shade.hpp", "highlight_phong", file, line});
    return highlight_phong<Recorded<Real>>(n, l, r, probe);
}
template <std::floating_point Real, class Highlight, class Probe>
auto terms(const Vec3<Recorded<Real>>& n, const Vec3<Recorded<Real>>& r, const Vec3<Recorded<Real>>& color,
           const Light<Recorded<Real>>& light, const Shading<Recorded<Real>>& shading, const Highlight& highlight,
           Probe& probe, const char* file = __builtin_FILE(), int line = __builtin_LINE()) {
    const Calling here(tape_of(n, r), {"shade.hpp", "terms", file, line});
    return terms<Recorded<Real>>(n, r, color, light, shading, highlight, probe);
}
template <std::floating_point Real, class Probe>
auto shade(const Vec3<Recorded<Real>>& surface_normal, const Vec3<Recorded<Real>>& r, const Vec3<Recorded<Real>>& color,
           const Light<Recorded<Real>>& light, const Shading<Recorded<Real>>& shading, Probe& probe,
           const char* file = __builtin_FILE(), int line = __builtin_LINE()) {
    const Calling here(tape_of(surface_normal, r), {"shade.hpp", "shade", file, line});
    return shade<Recorded<Real>>(surface_normal, r, color, light, shading, probe);
}
template <std::floating_point Real>
auto to_rgb(const Terms<Recorded<Real>>& terms, const char* file = __builtin_FILE(), int line = __builtin_LINE()) {
    const Calling here(tape_of(terms.diffuse, terms.ambient), {"shade.hpp", "to_rgb", file, line});
    return to_rgb<Recorded<Real>>(terms);
}
template <std::floating_point Real, class Probe>
auto shade_as_published(const Vec3<Recorded<Real>>& n, const Vec3<Recorded<Real>>& r, const Vec3<Recorded<Real>>& color,
                        const Light<Recorded<Real>>& light, const Shading<Recorded<Real>>& shading, Probe& probe,
                        const char* file = __builtin_FILE(), int line = __builtin_LINE()) {
    const Calling here(tape_of(n, r), {"published_shading.hpp", "shade_as_published", file, line});
    return shade_as_published<Recorded<Real>>(n, r, color, light, shading, probe);
}
template <std::floating_point Real>
auto to_rgb_as_published(const Terms<Recorded<Real>>& terms, const char* file = __builtin_FILE(),
                         int line = __builtin_LINE()) {
    const Calling here(tape_of(terms.diffuse, terms.ambient),
                       {"published_shading.hpp", "to_rgb_as_published", file, line});
    return to_rgb_as_published<Recorded<Real>>(terms);
}
template <std::floating_point Real, class Probe>
auto shade_by_model(const Vec3<Recorded<Real>>& n, const Vec3<Recorded<Real>>& r, const Vec3<Recorded<Real>>& color,
                    const Light<Recorded<Real>>& light, const Shading<Recorded<Real>>& shading, Probe& probe,
                    const char* file = __builtin_FILE(), int line = __builtin_LINE()) {
    const Calling here(tape_of(n, r), {"shade_by_model.hpp", "shade_by_model", file, line});
    return shade_by_model<Recorded<Real>>(n, r, color, light, shading, probe);
}
template <std::floating_point Real>
auto to_rgb(const Terms<Recorded<Real>>& terms, ShadingModel model, const char* file = __builtin_FILE(),
            int line = __builtin_LINE()) {
    const Calling here(tape_of(terms.diffuse, terms.ambient), {"shade_by_model.hpp", "to_rgb", file, line});
    return to_rgb<Recorded<Real>>(terms, model);
}

}  // namespace glassbox
