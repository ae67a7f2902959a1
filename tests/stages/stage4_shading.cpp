// Stage 4: light on a surface, term by term, by three models, and how the terms become a pixel.
#include <algorithm>
#include <light.hpp>
#include <probe.hpp>
#include <rgb.hpp>
#include <shade_by_model.hpp>

#include "checks.hpp"

using namespace glassbox;
using namespace glassbox::test;

namespace {

constexpr std::array<ShadingModel, 3> models{ShadingModel::phong, ShadingModel::blinn_phong,
                                             ShadingModel::levental_2014};

/// White light and highlight, pink surroundings, every factor 1.
template <class Real>
Shading<Real> full(ShadingModel model, const std::type_identity_t<Real>& exponent) {
    return {model, 1, 1, 1, exponent, {255, 102, 102}, {255, 255, 255}};
}

template <class Real>
Terms<Real> shaded(const Vec3<Real>& n, const Vec3<Real>& r, const Vec3<Real>& color, const Light<Real>& light,
                   const Shading<Real>& shading) {
    Silent silent;
    return shade_by_model(n, r, color, light, shading, silent);
}

/// Everything happens in the plane y = 0, about a surface that looks up. The angle between `up` and `slanted` has the
/// cosine 0.8: (3, 0, 4) has length 5.
template <class Real>
const Vec3<Real> up{0, 0, 1};
template <class Real>
const Vec3<Real> slanted{Real(3) / 5, 0, Real(4) / 5};
template <class Real>
const Vec3<Real> mirrored{Real(-3) / 5, 0, Real(4) / 5};  // where light from `slanted` goes
template <class Real>
const Vec3<Real> color{100, 50, 200};

}  // namespace

TEST_CASE_TEMPLATE("of a light only the direction counts, and its intensity", Real, EVERY_SCALAR) {
    for (const Real size : sizes<Real>) {
        const Light<Real> light = directional_light(size * Vec3<Real>{2, 3, 6}, Real(0.5));  // (2, 3, 6) has length 7
        CHECK_EXACT(light.l, (Vec3<Real>{Real(2) / 7, Real(3) / 7, Real(6) / 7}));
        CHECK_EXACT(light.intensity, Real(0.5));
        CHECK_EXACT(light.L, (size * Vec3<Real>{2, 3, 6}));
    }
}

TEST_CASE_TEMPLATE("the positive part of a number is itself or 0, and 0 for not a number", Real, EVERY_SCALAR) {
    CHECK_EXACT(positive_part(Real(0.25)), Real(0.25));
    CHECK_EXACT(positive_part(Real(-0.25)), Real(0));
    CHECK_EXACT(positive_part(Real(0)), Real(0));
    CHECK_EXACT(positive_part(std::numeric_limits<Real>::infinity()), std::numeric_limits<Real>::infinity());
    CHECK_EXACT(positive_part(std::numeric_limits<Real>::quiet_NaN()), Real(0));
}

TEST_CASE_TEMPLATE("the half vector lies midway, with length 1; between opposites there is none", Real, EVERY_SCALAR) {
    CHECK_EXACT(halfway(up<Real>, up<Real>), up<Real>);
    CHECK_EXACT(halfway(slanted<Real>, mirrored<Real>), up<Real>);
    CHECK_EXACT(halfway(slanted<Real>, -slanted<Real>), Vec3<Real>{});
    // nearly opposite, 2^-30 of their length apart: the sum is (0, 2^-30, 0), short but not 0
    CHECK_EXACT(halfway(Vec3<Real>{1, 0, 0}, Vec3<Real>{-1, Real(0x1p-30), 0}), (Vec3<Real>{0, 1, 0}));
    Dice dice;
    for (int n = 0; n < 200; ++n) {
        const Vec3<Real> a = unit(dice.vector(Real(1))), b = unit(dice.vector(Real(1)));
        if (length(a + b) < Real(0.1)) continue;
        const Vec3<Real> h = halfway(a, b);
        CHECK_WITHIN(length(h), Real(1), 4 * epsilon<Real>);
        CHECK_WITHIN(dot(h, a), dot(h, b), 40 * epsilon<Real>);  // a + b down to 0.1 long: up to ten times the rounding
    }
}

TEST_CASE_TEMPLATE("a normal is turned to the side that the viewer sees", Real, EVERY_SCALAR) {
    CHECK_EXACT(towards(up<Real>, up<Real>), up<Real>);
    CHECK_EXACT(towards(up<Real>, -up<Real>), up<Real>);
    CHECK_EXACT(towards(slanted<Real>, -up<Real>), up<Real>);              // 0.8 of -up: away
    CHECK_EXACT(towards(slanted<Real>, -mirrored<Real>), mirrored<Real>);  // (0.6, 0, -0.8): 0.36 - 0.64 is away, too
    CHECK_EXACT(towards(Vec3<Real>{1, 0, 0}, up<Real>), up<Real>);         // seen from the side: as it is
}

TEST_CASE_TEMPLATE("diffuse: I k_d n.l, from before the surface", Real, EVERY_SCALAR) {
    CHECK_EXACT(diffuse(Real(1), Real(1), Real(0.75)), Real(0.75));
    CHECK_EXACT(diffuse(Real(0.5), Real(1), Real(0.75)), Real(0.375));
    CHECK_EXACT(diffuse(Real(0.5), Real(0.25), Real(0.75)), Real(0.09375));
}

TEST_CASE_TEMPLATE("diffuse cuts: light from behind is none, and what is not a number, too", Real, EVERY_SCALAR) {
    CHECK_EXACT(diffuse(Real(1), Real(1), Real(-0.75)), Real(0));
    CHECK_EXACT(diffuse(Real(1), Real(1), std::numeric_limits<Real>::quiet_NaN()), Real(0));
}

TEST_CASE_TEMPLATE("reflected: the mirror keeps what is along n and turns what is across", Real, EVERY_SCALAR) {
    const Vec3<Real> z{0, 0, 1};
    CHECK_EXACT(reflected(Vec3<Real>{3, -4, 12}, z), (Vec3<Real>{-3, 4, 12}));
    CHECK_EXACT(reflected(z, z), z);                                             // straight back
    CHECK_EXACT(reflected(Vec3<Real>{1, 0, 0}, z), (Vec3<Real>{-1, 0, 0}));      // grazing light goes on
    CHECK_EXACT(reflected(Vec3<Real>{3, -4, 12}, -z), (Vec3<Real>{-3, 4, 12}));  // a mirror has no sides
    Dice dice;
    for (int k = 0; k < 200; ++k) {
        const Vec3<Real> l = unit(dice.vector(Real(1))), n = unit(dice.vector(Real(1)));
        CHECK_WITHIN(length(reflected(l, n)), Real(1), 8 * epsilon<Real>);
        CHECK_WITHIN(dot(reflected(l, n), n), dot(l, n), 8 * epsilon<Real>);
    }
}

TEST_CASE_TEMPLATE("specular: I k_s cosine^e, where the cosine is above 0", Real, EVERY_SCALAR) {
    CHECK_ULPS(specular(Real(1), Real(1), Real(0.5), Real(3)), Real(0.125), 1);
    CHECK_ULPS(specular(Real(0.5), Real(0.25), Real(0.5), Real(2)), Real(0.03125), 1);
    CHECK_EXACT(specular(Real(0.5), Real(1), Real(1), Real(15)), Real(0.5));
}

TEST_CASE_TEMPLATE("specular cuts: a cosine below 0 is none, to an even power, too, and so is what is not a number",
                   Real, EVERY_SCALAR) {
    CHECK_EXACT(specular(Real(1), Real(1), Real(-0.5), Real(2)), Real(0));
    CHECK_EXACT(specular(Real(1), Real(1), std::numeric_limits<Real>::quiet_NaN(), Real(2)), Real(0));
}

TEST_CASE_TEMPLATE("Blinn: the cosine between the normal and the half vector", Real, EVERY_SCALAR) {
    Silent silent;
    // light and viewer on both sides of the normal: h = n
    CHECK_ULPS(highlight_blinn(up<Real>, slanted<Real>, mirrored<Real>, silent), Real(1), 2);
    // h = unit(0.6, 0, 1.8) = (1, 0, 3)/sqrt 10
    CHECK_ULPS(highlight_blinn(up<Real>, slanted<Real>, up<Real>, silent), std::sqrt(Real(9) / 10), 4);
    // h = up, and the cosine between up and slanted is 0.8
    CHECK_ULPS(highlight_blinn(slanted<Real>, up<Real>, up<Real>, silent), Real(4) / 5, 2);
    // seen from behind it is negative: what shades cuts it off
    CHECK_ULPS(highlight_blinn(-up<Real>, slanted<Real>, mirrored<Real>, silent), Real(-1), 2);
}

TEST_CASE_TEMPLATE("Phong: the cosine between the viewer and the mirrored light", Real, EVERY_SCALAR) {
    Silent silent;
    CHECK_ULPS(highlight_phong(up<Real>, slanted<Real>, mirrored<Real>, silent), Real(1), 4);
    // from straight above: the mirrored light is (-0.6, 0, 0.8)
    CHECK_ULPS(highlight_phong(up<Real>, slanted<Real>, up<Real>, silent), Real(4) / 5, 4);
    // light along the normal comes straight back
    CHECK_ULPS(highlight_phong(slanted<Real>, slanted<Real>, up<Real>, silent), Real(4) / 5, 4);
    // and away from the mirrored light
    CHECK_ULPS(highlight_phong(up<Real>, slanted<Real>, -mirrored<Real>, silent), Real(-1), 4);
}

TEST_CASE_TEMPLATE("diffuse light is I k_d n.l times the surface's own colour", Real, EVERY_SCALAR) {
    for (const ShadingModel model : models) {
        Shading<Real> shading = full<Real>(model, 1);
        // n.l = cos = 0.8: (80, 40, 160)
        const Light<Real> light = directional_light(Vec3<Real>{3, 0, 4}, 1);
        CHECK_ULPS(shaded(up<Real>, up<Real>, color<Real>, light, shading).diffuse, (Vec3<Real>{80, 40, 160}), 4);
        // half the light and a quarter of the answer: an eighth
        shading.k_d = Real(0.25);
        const Light<Real> weak = directional_light(Vec3<Real>{3, 0, 4}, Real(0.5));
        CHECK_ULPS(shaded(up<Real>, up<Real>, color<Real>, weak, shading).diffuse, (Vec3<Real>{10, 5, 20}), 4);
        // from straight above all of it; at 60 degrees, l = (sqrt 3, 0, 1)/2, half
        const Light<Real> above = directional_light(up<Real>, 1),
                          low = directional_light(Vec3<Real>{std::sqrt(Real(3)), 0, 1}, 1);
        shading.k_d = 1;
        CHECK_EXACT(shaded(up<Real>, up<Real>, color<Real>, above, shading).diffuse, color<Real>);
        CHECK_ULPS(shaded(up<Real>, up<Real>, color<Real>, low, shading).diffuse, color<Real> / 2, 4);
    }
}

TEST_CASE_TEMPLATE("light from behind the surface is no diffuse light, not negative light", Real, EVERY_SCALAR) {
    for (const ShadingModel model : models) {
        const Light<Real> below = directional_light(Vec3<Real>{3, 0, -4}, 1),
                          level = directional_light(Vec3<Real>{1, 0, 0}, 1);
        CHECK_EXACT(shaded(up<Real>, up<Real>, color<Real>, below, full<Real>(model, 1)).diffuse, Vec3<Real>{});
        CHECK_EXACT(shaded(up<Real>, up<Real>, color<Real>, level, full<Real>(model, 1)).diffuse, Vec3<Real>{});
    }
}

TEST_CASE_TEMPLATE("ambient light is k_a of a warm pink, whatever the surface, the light and the view", Real,
                   EVERY_SCALAR) {
    for (const ShadingModel model : models) {
        Shading<Real> shading = full<Real>(model, 15);
        for (const Vec3<Real>& surface : {Vec3<Real>{0, 255, 0}, Vec3<Real>{0, 0, 0}, color<Real>}) {
            for (const Vec3<Real>& L : {up<Real>, -up<Real>, slanted<Real>}) {
                const Light<Real> light = directional_light(L, Real(0.25));
                shading.k_a = 1;
                CHECK_EXACT(shaded(up<Real>, slanted<Real>, surface, light, shading).ambient,
                            (Vec3<Real>{255, 102, 102}));
                shading.k_a = Real(0.5);
                CHECK_EXACT(shaded(up<Real>, slanted<Real>, surface, light, shading).ambient,
                            (Vec3<Real>{Real(127.5), 51, 51}));
            }
        }
    }
}

TEST_CASE_TEMPLATE("opposite light and view make no highlight, and no NaN", Real, EVERY_SCALAR) {
    const Light<Real> light = directional_light(Vec3<Real>{3, 0, 4}, 1);
    const Terms<Real> terms = shaded(up<Real>, -light.l, color<Real>, light, full<Real>(ShadingModel::blinn_phong, 15));
    CHECK_EXACT(terms.specular, Vec3<Real>{});
}

TEST_CASE_TEMPLATE("where the viewer stands in the mirrored light the highlight is full, by both forms", Real,
                   EVERY_SCALAR) {
    // h = n, so n.h = 1; and the mirrored light is r itself, so r.(2(n.l)n - l) = 1. A power of 15 turns each ulp
    // into 15.
    const Light<Real> light = directional_light(Vec3<Real>{3, 0, 4}, 1);
    for (const ShadingModel model : {ShadingModel::phong, ShadingModel::blinn_phong}) {
        for (const int exponent : {1, 2, 15}) {
            const Shading<Real> shading = full<Real>(model, static_cast<Real>(exponent));
            CHECK_ULPS(shaded(up<Real>, mirrored<Real>, color<Real>, light, shading).specular,
                       (Vec3<Real>{255, 255, 255}), 60);
        }
    }
}

TEST_CASE_TEMPLATE("elsewhere Blinn's highlight is the wider one: it falls with half the angle", Real, EVERY_SCALAR) {
    // Seen from straight above. Phong: the mirrored light is (-0.6, 0, 0.8), its cosine to r 0.8, squared 0.64.
    // Blinn: h = unit(0.6, 0, 1.8) = (1, 0, 3)/sqrt 10, so n.h = 3/sqrt 10, squared 0.9. (And 2 * 0.9 - 1 = 0.8: half
    // the angle.)
    const Light<Real> light = directional_light(Vec3<Real>{3, 0, 4}, 1);
    const Terms<Real> phong = shaded(up<Real>, up<Real>, color<Real>, light, full<Real>(ShadingModel::phong, 2));
    const Terms<Real> blinn = shaded(up<Real>, up<Real>, color<Real>, light, full<Real>(ShadingModel::blinn_phong, 2));
    CHECK_ULPS(phong.specular.x, Real(16) / 25 * 255, 16);
    CHECK_ULPS(blinn.specular.x, Real(9) / 10 * 255, 16);
    CHECK_EXACT(phong.specular.y, phong.specular.x);  // white
    CHECK_EXACT(phong.specular.z, phong.specular.x);
}

TEST_CASE_TEMPLATE("a negative cosine makes no highlight, to an even power neither", Real, EVERY_SCALAR) {
    // Light from below. Phong, seen from above: the mirrored light is 2(-0.8)up - (0.6, 0, -0.8) = (-0.6, 0, -0.8), its
    // cosine to r is -0.8. Blinn, seen along the surface: h = unit((0.6, 0, -0.8) + (-1, 0, 0)) = unit(-0.4, 0, -0.8).
    const Light<Real> light = directional_light(Vec3<Real>{3, 0, -4}, 1);
    const Vec3<Real> along{-1, 0, 0};
    const Terms<Real> phong = shaded(up<Real>, up<Real>, color<Real>, light, full<Real>(ShadingModel::phong, 2));
    const Terms<Real> blinn = shaded(up<Real>, along, color<Real>, light, full<Real>(ShadingModel::blinn_phong, 2));
    CHECK_EXACT(phong.specular, Vec3<Real>{});
    CHECK_EXACT(blinn.specular, Vec3<Real>{});
}

TEST_CASE_TEMPLATE("the highlight grows with I and k_s, and is the light's colour, not the surface's", Real,
                   EVERY_SCALAR) {
    for (const ShadingModel model : models) {
        Shading<Real> shading = full<Real>(model, 1);
        shading.specular_color = {40, 80, 160};
        shading.k_s = Real(0.5);
        const Light<Real> light = directional_light(up<Real>, Real(0.5));
        // light, viewer and normal in one line: cosine 1, so a quarter of the colour
        CHECK_EXACT(shaded(up<Real>, up<Real>, color<Real>, light, shading).specular, (Vec3<Real>{10, 20, 40}));
    }
}

TEST_CASE_TEMPLATE("a surface seen from behind is lit as from the front, but not by the paper's program", Real,
                   EVERY_SCALAR) {
    const Light<Real> light = directional_light(up<Real>, 1);
    for (const ShadingModel model : {ShadingModel::phong, ShadingModel::blinn_phong}) {
        const Terms<Real> back = shaded(-up<Real>, up<Real>, color<Real>, light, full<Real>(model, 15));
        CHECK_EXACT(back.diffuse, color<Real>);
        CHECK_EXACT(back.specular, (Vec3<Real>{255, 255, 255}));
    }
    const Terms<Real> dark =
        shaded(-up<Real>, up<Real>, color<Real>, light, full<Real>(ShadingModel::levental_2014, 15));
    CHECK_EXACT(dark.diffuse, Vec3<Real>{});
    CHECK_EXACT(dark.specular, Vec3<Real>{});
}

TEST_CASE_TEMPLATE("the paper's half vector hardly leaves the light: its L is 1060 long, r only 1", Real,
                   EVERY_SCALAR) {
    // The front of the green sphere: n = r = (1, 0, 0). |L|^2 = 1000^2 + 2 * 250^2 = 1125000, n.l = 1000/sqrt 1125000
    // = 0.9428. Blinn's h bisects: n.h = sqrt((1 + n.l)/2) = 0.9856. The paper's is unit(1001, 250, 250):
    // 1001^2 + 125000 = 1127001, n.h = 1001/sqrt 1127001 = 0.9429.
    const Vec3<Real> x{1, 0, 0};
    const Light<Real> light = directional_light(Vec3<Real>{1000, 250, 250}, 1);
    const Terms<Real> blinn = shaded(x, x, color<Real>, light, full<Real>(ShadingModel::blinn_phong, 1));
    const Terms<Real> paper = shaded(x, x, color<Real>, light, full<Real>(ShadingModel::levental_2014, 1));
    CHECK_ULPS(blinn.specular.x, 255 * std::sqrt((1 + 1000 / std::sqrt(Real(1125000))) / 2), 8);
    CHECK_ULPS(paper.specular.x, 255 * (1001 / std::sqrt(Real(1127001))), 8);
    CHECK(blinn.specular.x - paper.specular.x > 10);  // 255 * (0.9856 - 0.9429) = 10.9
}

TEST_CASE_TEMPLATE("the front of the paper's green sphere, in its final picture: (72, 255, 41)", Real, EVERY_SCALAR) {
    // (k_a, k_d, k_s) = (.2, 1, .2), exponent 15, n = r = (1, 0, 0).
    //   ambient   .2 (255, 102, 102)             = (51, 20.4, 20.4)  -> (51, 20, 20)
    //   diffuse   0.942809 (0, 255, 0)           = (0, 240.4, 0)     -> (0, 240, 0)
    //   specular  .2 * 0.942914^15 = .2 * 0.4141, times 255 = 21.1   -> (21, 21, 21)
    // and 20 + 240 + 21 = 281 is held at 255.
    Shading<Real> shading = full<Real>(ShadingModel::levental_2014, 15);
    shading.k_a = shading.k_s = Real(1) / 5;
    const Vec3<Real> x{1, 0, 0};
    const Light<Real> light = directional_light(Vec3<Real>{1000, 250, 250}, 1);
    const Rgb pixel = to_rgb(shaded(x, x, Vec3<Real>{0, 255, 0}, light, shading), shading.model);
    CHECK(int{pixel.red} == 72);
    CHECK(int{pixel.green} == 255);
    CHECK(int{pixel.blue} == 41);
}

namespace {

/// A probe that keeps what is reported to it, the last of each.
struct Kept {
    double n_l = 0, n_r = 0, n_h = 0, r_m = 0, ambient = 0, diffuse = 0, specular = 0;
    Vec3<double> h, reflection;

    template <class What, class... Values>
    void operator()(What, const Values&...) {}
    void operator()(told::NormalLight, double value) { n_l = value; }
    void operator()(told::NormalViewer, double value) { n_r = value; }
    void operator()(told::HalfVector, const Vec3<double>& value) { h = value; }
    void operator()(told::NormalHalf, double value) { n_h = value; }
    void operator()(told::Reflection, const Vec3<double>& value, double cosine) { reflection = value, r_m = cosine; }
    void operator()(told::Ambient, double value) { ambient = value; }
    void operator()(told::DiffuseTerm, double value) { diffuse = value; }
    void operator()(told::SpecularTerm, double value) { specular = value; }
};

/// What shading reports with the light from `slanted`, seen from `mirrored`, n = up, and I = 0.5.
Kept told_by(ShadingModel model) {
    const Light<double> light = directional_light(Vec3<double>{3, 0, 4}, 0.5);
    Shading<double> shading = full<double>(model, 2);
    shading.k_a = 0.75, shading.k_d = 0.5, shading.k_s = 0.25;
    Kept kept;
    shade_by_model(up<double>, mirrored<double>, color<double>, light, shading, kept);
    return kept;
}

}  // namespace

TEST_CASE("shading tells its probe the cosines and what they are of, so that they can be measured") {
    // n.l = n.r = 0.8, h = up, and the mirrored light is r
    const Kept blinn = told_by(ShadingModel::blinn_phong), phong = told_by(ShadingModel::phong);
    CHECK_ULPS(blinn.n_l, 0.8, 4);
    CHECK_ULPS(blinn.n_r, 0.8, 4);
    CHECK_ULPS(blinn.h, up<double>, 2);
    CHECK_ULPS(blinn.n_h, 1.0, 2);
    CHECK_ULPS(phong.reflection, mirrored<double>, 4);
    CHECK_ULPS(phong.r_m, 1.0, 4);
}

TEST_CASE("shading tells its probe the factor of each term") {
    // diffuse 0.5 * 0.5 * 0.8 = 0.2, specular 0.5 * 0.25 * 1
    for (const Kept& kept : {told_by(ShadingModel::blinn_phong), told_by(ShadingModel::phong)}) {
        CHECK_EXACT(kept.ambient, 0.75);
        CHECK_ULPS(kept.diffuse, 0.2, 4);
        CHECK_ULPS(kept.specular, 0.125, 16);
    }
}

TEST_CASE_TEMPLATE("a number becomes a byte: cut to 0 … 255, and NaN to 0", Real, EVERY_SCALAR) {
    const Real infinity = std::numeric_limits<Real>::infinity(), nan = std::numeric_limits<Real>::quiet_NaN();
    struct Case {
        Real value;
        int truncated, rounded;
    };
    for (const Case& c :
         {Case{0, 0, 0}, Case{Real(0.25), 0, 0}, Case{Real(0.5), 0, 1}, Case{Real(0.75), 0, 1}, Case{Real(1.5), 1, 2},
          Case{127, 127, 127}, Case{Real(254.25), 254, 254}, Case{Real(254.75), 254, 255}, Case{255, 255, 255},
          Case{Real(255.5), 255, 255}, Case{300, 255, 255}, Case{-1, 0, 0}, Case{Real(-0.25), 0, 0},
          Case{infinity, 255, 255}, Case{-infinity, 0, 0}, Case{nan, 0, 0}}) {
        CAPTURE(c.value);
        CHECK(int{truncated_byte(c.value)} == c.truncated);
        CHECK(int{rounded_byte(c.value)} == c.rounded);
    }
    CHECK((rounded(Vec3<Real>{nan, 300, Real(1.5)}) == Rgb{0, 255, 2}));
    CHECK((truncated(Vec3<Real>{nan, 300, Real(1.5)}) == Rgb{0, 255, 1}));
}

TEST_CASE_TEMPLATE("light has the colour's channels, and none where the colour has none, however bright", Real,
                   EVERY_SCALAR) {
    const Real infinity = std::numeric_limits<Real>::infinity(), nan = std::numeric_limits<Real>::quiet_NaN();
    CHECK_EXACT(tinted(Real(0.5), Vec3<Real>{10, 0, 200}), (Vec3<Real>{5, 0, 100}));
    CHECK_EXACT(tinted(infinity, Vec3<Real>{10, 0, 200}), (Vec3<Real>{infinity, 0, infinity}));
    CHECK_EXACT(tinted(Real(0), Vec3<Real>{10, 0, 200}), Vec3<Real>{});
    CHECK_EXACT(tinted(nan, Vec3<Real>{10, 0, 200}), Vec3<Real>{});
}

TEST_CASE("bytes add up to 255 and no further") {
    CHECK((Rgb{1, 2, 3} + Rgb{4, 5, 6} == Rgb{5, 7, 9}));
    CHECK((Rgb{200, 255, 254} + Rgb{100, 255, 1} == Rgb{255, 255, 255}));
}

TEST_CASE_TEMPLATE("the paper cuts each term to a whole byte before it adds them", Real, EVERY_SCALAR) {
    const Real tenths = Real(0.9);
    const Terms<Real> terms{{tenths, tenths, tenths}, {tenths, tenths, tenths}, {tenths, tenths, tenths}};
    // 0 + 0 + 0 = 0, where 2.7 rounds to 3
    CHECK((to_rgb(terms, ShadingModel::levental_2014) == Rgb{0, 0, 0}));
    CHECK((to_rgb(terms, ShadingModel::blinn_phong) == Rgb{3, 3, 3}));
    CHECK((to_rgb(terms, ShadingModel::phong) == Rgb{3, 3, 3}));
}

TEST_CASE_TEMPLATE("too much light is white, by every model", Real, EVERY_SCALAR) {
    const Terms<Real> bright{{200, 200, 200}, {100, 100, 100}, {1000, 1000, 1000}};
    for (const ShadingModel model : models) CHECK((to_rgb(bright, model) == Rgb{255, 255, 255}));
}

TEST_CASE_TEMPLATE("a surface without a normal gets ambient light only, never NaN", Real, EVERY_SCALAR) {
    // unit(0) is not a number, as of a triangle without area; max(0, NaN) is 0 here
    const Real nan = std::numeric_limits<Real>::quiet_NaN();
    const Light<Real> light = directional_light(up<Real>, 1);
    for (const ShadingModel model : models) {
        const Terms<Real> terms = shaded({nan, nan, nan}, up<Real>, color<Real>, light, full<Real>(model, 15));
        CHECK_EXACT(terms.diffuse, Vec3<Real>{});
        CHECK_EXACT(terms.specular, Vec3<Real>{});
        CHECK((to_rgb(terms, model) == Rgb{255, 102, 102}));
    }
}

TEST_CASE_TEMPLATE("no term is ever negative, and the terms add to the pixel", Real, EVERY_SCALAR) {
    Dice dice;
    for (const ShadingModel model : models) {
        for (int n = 0; n < 300; ++n) {
            const Vec3<Real> normal = unit(dice.vector(Real(1))), r = unit(dice.vector(Real(1)));
            const Light<Real> light = directional_light(dice.vector(Real(1000)), 1);
            const Terms<Real> terms = shaded(normal, r, color<Real>, light, full<Real>(model, 15));
            for (const Vec3<Real>& term : {terms.ambient, terms.diffuse, terms.specular}) {
                CHECK(std::min({term.x, term.y, term.z}) >= 0);
            }
            if (model != ShadingModel::levental_2014)
                CHECK((to_rgb(terms, model) == rounded(terms.ambient + terms.diffuse + terms.specular)));
        }
    }
}
