// Stage 1: vectors, rays, and the viewing plane that sends a ray through every pixel.
#include <ray.hpp>
#include <ray_color.hpp>
#include <viewing_plane.hpp>

#include "checks.hpp"

using namespace glassbox;
using namespace glassbox::test;

TEST_CASE_TEMPLATE("vectors add, subtract and scale component by component", Real, EVERY_SCALAR) {
    const Vec3<Real> a{1, 2, 3}, b{4, -6, 8};
    CHECK_EXACT(a + b, (Vec3<Real>{5, -4, 11}));
    CHECK_EXACT(a - b, (Vec3<Real>{-3, 8, -5}));
    CHECK_EXACT(-a, (Vec3<Real>{-1, -2, -3}));
    CHECK_EXACT(3 * a, (Vec3<Real>{3, 6, 9}));
    CHECK_EXACT(b / 2, (Vec3<Real>{2, -3, 4}));
}

TEST_CASE_TEMPLATE("a.b adds up the products of the components", Real, EVERY_SCALAR) {
    // 1*4 + 2*(-5) + 3*6 = 4 - 10 + 18 = 12
    CHECK_EXACT(dot(Vec3<Real>{1, 2, 3}, Vec3<Real>{4, -5, 6}), Real(12));
    // at right angles: 1*2 + 2*1 + 2*(-2) = 0
    CHECK_EXACT(dot(Vec3<Real>{1, 2, 2}, Vec3<Real>{2, 1, -2}), Real(0));
    // at 60 degrees |a||b|/2: (1,1,0) and (1,0,1) both have length sqrt 2, so 1
    CHECK_EXACT(dot(Vec3<Real>{1, 1, 0}, Vec3<Real>{1, 0, 1}), Real(1));
}

TEST_CASE_TEMPLATE("a.b = b.a to the bit, and each power of two can be taken out of it", Real, EVERY_SCALAR) {
    Dice dice;
    for (const Real size : sizes<Real>) {
        for (int n = 0; n < 200; ++n) {
            const Vec3<Real> a = dice.vector(Real(1)), b = dice.vector(Real(1));
            CHECK_EXACT(dot(a, b), dot(b, a));
            CHECK_EXACT(dot(size * a, b), size * dot(a, b));
        }
    }
}

TEST_CASE_TEMPLATE("a x b is right-handed: x x y = z, y x z = x, z x x = y", Real, EVERY_SCALAR) {
    const Vec3<Real> x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};
    CHECK_EXACT(cross(x, y), z);
    CHECK_EXACT(cross(y, z), x);
    CHECK_EXACT(cross(z, x), y);
    // (2*6 - 3*5, 3*4 - 1*6, 1*5 - 2*4) = (-3, 6, -3)
    CHECK_EXACT(cross(Vec3<Real>{1, 2, 3}, Vec3<Real>{4, 5, 6}), (Vec3<Real>{-3, 6, -3}));
}

TEST_CASE_TEMPLATE("swapping a and b flips every sign of a x b, to the bit", Real, EVERY_SCALAR) {
    // a.y*b.z - a.z*b.y and b.y*a.z - b.z*a.y round the same two products, then their difference: one is exactly minus
    // the other. (A fused multiply-add would round only one of the products, and the triangles would leak.)
    Dice dice;
    for (const Real size : sizes<Real>) {
        CAPTURE(size);
        for (int n = 0; n < 1000; ++n) {
            const Vec3<Real> a = dice.vector(size), b = dice.vector(Real(1)) + a / 3;
            CHECK_EXACT(cross(a, b), -cross(b, a));
            CHECK_EXACT(cross(a, a), (Vec3<Real>{0, 0, 0}));
        }
    }
}

TEST_CASE_TEMPLATE("a x b stands at right angles to a and to b", Real, EVERY_SCALAR) {
    // In exact numbers a.(a x b) = 0. The six products |a_i a_j b_k| that cancel are each at most |a||a||b|; each
    // passes through at most six roundings of half an epsilon: 6 * 6/2 = 18.
    Dice dice;
    for (const Real size : sizes<Real>) {
        CAPTURE(size);
        for (int n = 0; n < 200; ++n) {
            const Vec3<Real> a = dice.vector(size), b = dice.vector(Real(1));
            CHECK_WITHIN(dot(a, cross(a, b)), Real(0), 18 * epsilon<Real> * size_of(a) * size_of(a) * size_of(b));
            CHECK_WITHIN(dot(b, cross(a, b)), Real(0), 18 * epsilon<Real> * size_of(a) * size_of(b) * size_of(b));
        }
    }
}

TEST_CASE_TEMPLATE("|a x b| and a.b are the sine and cosine of one angle", Real, EVERY_SCALAR) {
    // Lagrange: |a x b|^2 + (a.b)^2 = |a|^2 |b|^2. A component of a x b or a.b is off by at most 3 epsilon/2 |a||b|
    // each, the squares by twice that each: 4 * 2 * 1.5 = 12 epsilon, and 4 more for the squares, sums and the right
    // side.
    Dice dice;
    for (const Real size : sizes<Real>) {
        CAPTURE(size);
        for (int n = 0; n < 200; ++n) {
            const Vec3<Real> a = dice.vector(size), b = dice.vector(Real(1));
            const Vec3<Real> axb = cross(a, b);
            const Real squares = dot(axb, axb) + dot(a, b) * dot(a, b);
            CHECK_WITHIN(squares / (dot(a, a) * dot(b, b)), Real(1), 16 * epsilon<Real>);
        }
    }
}

TEST_CASE_TEMPLATE("|a| by Pythagoras, exact where the answer is a whole number", Real, EVERY_SCALAR) {
    for (const Real size : sizes<Real>) {
        CAPTURE(size);
        CHECK_EXACT(length(size * Vec3<Real>{3, 4, 0}), 5 * size);    //  9 + 16      = 25
        CHECK_EXACT(length(size * Vec3<Real>{2, -3, 6}), 7 * size);   //  4 +  9 + 36 = 49
        CHECK_EXACT(length(size * Vec3<Real>{-1, 4, 8}), 9 * size);   //  1 + 16 + 64 = 81
        CHECK_EXACT(length(size * Vec3<Real>{3, 4, 12}), 13 * size);  //  9 + 16 + 144 = 169
    }
    CHECK_EXACT(length(Vec3<Real>{}), Real(0));
}

TEST_CASE_TEMPLATE("|a| by Pythagoras, in all of its digits where the answer is no whole number", Real, EVERY_SCALAR) {
    CHECK_ULPS(length(Vec3<Real>{1, 1, 1}), std::sqrt(Real(3)), 1);
    // 0.01 + 0.04 + 0.04 = 0.09. A tenth is rounded, each square once more, and so are two sums and the root.
    CHECK_ULPS(length(Vec3<Real>{Real(1) / 10, Real(2) / 10, Real(2) / 10}), Real(3) / 10, 4);
}

TEST_CASE_TEMPLATE("unit(a) has length 1 and the direction of a, whatever a's size", Real, EVERY_SCALAR) {
    Dice dice;
    for (const Real size : sizes<Real>) {
        CAPTURE(size);
        // (2, 3, 6) has length 7: three divisions, each rounded once
        CHECK_EXACT(unit(size * Vec3<Real>{2, 3, 6}), (Vec3<Real>{Real(2) / 7, Real(3) / 7, Real(6) / 7}));
        for (int n = 0; n < 200; ++n) {
            const Vec3<Real> a = dice.vector(Real(1));
            const Vec3<Real> u = unit(size * a);
            CHECK_EXACT(u, unit(a));
            CHECK_WITHIN(length(u), Real(1), 4 * epsilon<Real>);  // dot 1.5, sqrt 0.5, division 0.5, and dot again
            CHECK_ULPS(length(a) * u, a, 4);
        }
    }
}

TEST_CASE_TEMPLATE("the zero vector has no direction: unit(0) is not a number", Real, EVERY_SCALAR) {
    const Vec3<Real> u = unit(Vec3<Real>{});
    CHECK(std::isnan(u.x));
    CHECK(std::isnan(u.y));
    CHECK(std::isnan(u.z));
}

TEST_CASE_TEMPLATE("at(ray, t) is P + tD", Real, EVERY_SCALAR) {
    const Ray<Real> ray{{1, 2, 3}, {4, -6, 8}};
    CHECK_EXACT(at(ray, 0), ray.P);
    CHECK_EXACT(at(ray, 1), (Vec3<Real>{5, -4, 11}));
    CHECK_EXACT(at(ray, Real(0.5)), (Vec3<Real>{3, -1, 7}));  // (1 + 2, 2 - 3, 3 + 4)
    CHECK_EXACT(at(ray, -1), (Vec3<Real>{-3, 8, -5}));        // behind the start
}

TEST_CASE_TEMPLATE("t counts in lengths of D: twice the D, half the t, the same point", Real, EVERY_SCALAR) {
    Dice dice;
    for (const Real size : sizes<Real>) {
        const Vec3<Real> P = dice.vector(Real(1)), D = dice.vector(Real(1));
        const Real t = dice.between(Real(0), Real(10));
        CHECK_EXACT(at(Ray<Real>{P, size * D}, t / size), at(Ray<Real>{P, D}, t));
    }
}

TEST_CASE_TEMPLATE("a ray with a NaN or an infinity anywhere cannot be traced", Real, EVERY_SCALAR) {
    const Real infinity = std::numeric_limits<Real>::infinity();
    const Ray<Real> good{{1, 2, 3}, {-1, 0, 0}};
    CHECK(is_valid(good));
    for (const Real bad : {std::numeric_limits<Real>::quiet_NaN(), infinity, -infinity}) {
        CAPTURE(bad);
        for (Real Vec3<Real>::*component : {&Vec3<Real>::x, &Vec3<Real>::y, &Vec3<Real>::z}) {
            Ray<Real> start = good, direction = good;
            start.P.*component = bad;
            direction.D.*component = bad;
            CHECK_FALSE(is_valid(start));
            CHECK_FALSE(is_valid(direction));
        }
    }
}

TEST_CASE_TEMPLATE("a ray needs a direction: D = 0 cannot be traced, the smallest D can", Real, EVERY_SCALAR) {
    const Real least = std::numeric_limits<Real>::denorm_min();
    const Real most = std::numeric_limits<Real>::max();
    CHECK_FALSE(is_valid(Ray<Real>{{1, 2, 3}, {0, 0, 0}}));
    CHECK_FALSE(is_valid(Ray<Real>{{1, 2, 3}, {Real(-0.0), 0, Real(-0.0)}}));
    CHECK(is_valid(Ray<Real>{{0, 0, 0}, {0, least, 0}}));
    CHECK(is_valid(Ray<Real>{{most, -most, most}, {most, most, most}}));
}

TEST_CASE("a ray becomes wider without change") {
    const Ray<float> ray{{0.1f, -2.5f, 1e10f}, {1e-10f, 3, 0}};
    CHECK(convert<float>(convert<double>(ray)).P == ray.P);
    CHECK(convert<double>(ray).D.x == static_cast<double>(1e-10f));
}

TEST_CASE_TEMPLATE("the paper's plane: the ray of column j and row i starts at (500, j, i)", Real, EVERY_SCALAR) {
    const Parallel<Real> view{{{500, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {-1, 0, 0}};
    for (const int j : {0, 1, 250, 499}) {
        for (const int i : {0, 1, 349, 499}) {
            const Ray<Real> ray = pixel_ray(view, static_cast<Real>(j), static_cast<Real>(i));
            CHECK_EXACT(ray.P, (Vec3<Real>{500, static_cast<Real>(j), static_cast<Real>(i)}));
            CHECK_EXACT(ray.D, (Vec3<Real>{-1, 0, 0}));
        }
    }
    // as long as the view's direction is, which need not be 1
    CHECK_EXACT(pixel_ray(Parallel<Real>{view.plane, {-2, 0, 0}}, 3, 5).D, (Vec3<Real>{-2, 0, 0}));
    // between pixels, too: a pixel's top-right corner lies half a step from its middle
    CHECK_EXACT(point(view.plane, Real(2.5), Real(7.5)), (Vec3<Real>{500, Real(2.5), Real(7.5)}));
}

TEST_CASE_TEMPLATE("columns count along right, rows along up, from the corner", Real, EVERY_SCALAR) {
    // corner + 3 right + 5 up = (1 + 3*2 + 5*0, 2 + 3*1 + 5*4, 3 + 3*0 - 5*1) = (7, 25, -2)
    CHECK_EXACT(point(ViewingPlane<Real>{{1, 2, 3}, {2, 1, 0}, {0, 4, -1}}, 3, 5), (Vec3<Real>{7, 25, -2}));
}

TEST_CASE_TEMPLATE("a pinhole's ray runs from the eye to its pixel", Real, EVERY_SCALAR) {
    // pixel (3, 5) is (500, 3, 5), and (500, 3, 5) - (1000, 250, 250) = (-500, -247, -245)
    const Ray<Real> ray = pixel_ray(Pinhole<Real>{{{500, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {1000, 250, 250}}, 3, 5);
    CHECK_EXACT(ray.P, (Vec3<Real>{1000, 250, 250}));
    CHECK_EXACT(ray.D, (Vec3<Real>{-500, -247, -245}));
}

TEST_CASE_TEMPLATE("every ray of a pinhole starts in the eye and crosses the plane at t = 1", Real, EVERY_SCALAR) {
    const ViewingPlane<Real> plane{{500, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    const Pinhole<Real> view{plane, {1000, 250, 250}};
    for (const int j : {0, 250, 499}) {
        for (const int i : {0, 100, 499}) {
            const Ray<Real> ray = pixel_ray(view, static_cast<Real>(j), static_cast<Real>(i));
            CHECK_EXACT(ray.P, view.eye);
            CHECK_EXACT(at(ray, 1), point(plane, static_cast<Real>(j), static_cast<Real>(i)));
        }
    }
}

TEST_CASE_TEMPLATE("looking along -x with z up, right is +y, as on the paper's plane", Real, EVERY_SCALAR) {
    // An eye in the origin, so that no subtraction rounds; 90 degrees high, so that the top edge is one unit up.
    const Pinhole<Real> view = looking<Real>({0, 0, 0}, {-5, 0, 0}, {0, 0, 1}, 90, 4, 2);
    // 2 rows span 2 units: a pixel is 1 wide, 1 high
    CHECK_ULPS(view.plane.right, (Vec3<Real>{0, 1, 0}), 2);
    CHECK_ULPS(view.plane.up, (Vec3<Real>{0, 0, 1}), 2);
    // 4 columns: their middles lie at -1.5, -0.5, 0.5, 1.5; 2 rows: -0.5, 0.5
    CHECK_ULPS(view.plane.corner, (Vec3<Real>{-1, Real(-1.5), Real(-0.5)}), 2);
}

TEST_CASE_TEMPLATE("the ray in the picture's middle runs towards look_at", Real, EVERY_SCALAR) {
    Dice dice;
    for (const Real size : sizes<Real>) {
        CAPTURE(size);
        for (int n = 0; n < 50; ++n) {
            const Vec3<Real> goal = dice.vector(size);
            if (length(cross(goal, Vec3<Real>{0, 0, 1})) < length(goal) / 10) continue;  // up would be ill-defined
            const Pinhole<Real> view = looking<Real>({0, 0, 0}, goal, {0, 0, 1}, 40, 101, 51);
            // pixel (50, 25) of 101 x 51 has as many to its left as to its right, and below as above
            CHECK_ULPS(pixel_ray(view, 50, 25).D, unit(goal), 16);
        }
    }
}

TEST_CASE_TEMPLATE("the field of view is the angle between the pixels' outer edges, not their middles", Real,
                   EVERY_SCALAR) {
    // The pixels' middles are at whole rows 0 … height-1; the outer edges half a row further, at -1/2 and height-1/2.
    // tan(fov/2) there is up/forward: 1 for 90 degrees, 1/sqrt 3 for 60.
    struct Angle {
        Real degrees, tangent;
    };
    for (const Angle& angle : {Angle{90, 1}, Angle{60, 1 / std::sqrt(Real(3))}}) {
        for (const int height : {1, 2, 51, 100}) {
            CAPTURE(angle.degrees);
            CAPTURE(height);
            const int width = 2 * height;  // pixels are square: this picture is twice as wide as high
            const Pinhole<Real> view = looking<Real>({0, 0, 0}, {0, 3, 0}, {0, 0, 1}, angle.degrees, width, height);
            const Real h = static_cast<Real>(height), w = static_cast<Real>(width);
            const Real middle_j = (w - 1) / 2, middle_i = (h - 1) / 2;
            CHECK_WITHIN(pixel_ray(view, middle_j, h - Real(0.5)).D.z, angle.tangent, 8 * epsilon<Real>);
            CHECK_WITHIN(pixel_ray(view, middle_j, Real(-0.5)).D.z, -angle.tangent, 8 * epsilon<Real>);
            CHECK_WITHIN(pixel_ray(view, w - Real(0.5), middle_i).D.x, 2 * angle.tangent, 16 * epsilon<Real>);
            CHECK_WITHIN(pixel_ray(view, Real(-0.5), middle_i).D.x, -2 * angle.tangent, 16 * epsilon<Real>);
            CHECK_WITHIN(pixel_ray(view, middle_j, middle_i).D.y, Real(1), 4 * epsilon<Real>);
        }
    }
}

TEST_CASE_TEMPLATE("up need not stand at right angles to the view, nor have length 1", Real, EVERY_SCALAR) {
    const Pinhole<Real> straight = looking<Real>({0, 0, 0}, {0, 2, 0}, {0, 0, 1}, 50, 30, 20);
    const Pinhole<Real> tilted = looking<Real>({0, 0, 0}, {0, 2, 0}, {0, 7, 9}, 50, 30, 20);
    CHECK_ULPS(tilted.plane.right, straight.plane.right, 4);
    CHECK_ULPS(tilted.plane.up, straight.plane.up, 4);
    CHECK_ULPS(tilted.plane.corner, straight.plane.corner, 4);
}

TEST_CASE_TEMPLATE("a ray's colour: x, y, z from -1 to 1 are red, green, blue from dark to full", Real, EVERY_SCALAR) {
    // (-1, 0, 0): red 0, green and blue in the middle, 255/2
    CHECK_EXACT(ray_color(Ray<Real>{{9, 9, 9}, {-3, 0, 0}}, 0, 0), (Vec3<Real>{0, Real(127.5), Real(127.5)}));
    CHECK_EXACT(ray_color(Ray<Real>{{9, 9, 9}, {0, 5, 0}}, 0, 0), (Vec3<Real>{Real(127.5), 255, Real(127.5)}));
    // squares of 50 pixels: (49, 49) is in the first, (50, 49) in the darker one beside it (204), (50, 50) light again
    CHECK_EXACT(ray_color(Ray<Real>{{}, {1, 0, 0}}, 49, 49).x, Real(255));
    CHECK_EXACT(ray_color(Ray<Real>{{}, {1, 0, 0}}, 50, 49).x, Real(204));
    CHECK_EXACT(ray_color(Ray<Real>{{}, {1, 0, 0}}, 50, 50).x, Real(255));
}
