#include "viewer/model/state/picture_view.hpp"

#include <doctest.h>

#include <initializer_list>

using namespace glassbox;

TEST_CASE("A fitted picture is as large as the area allows, and in its middle") {
    // 500 × 500 into 800 × 600: the height decides, zoom 600/500; (800 − 600)/2 = 100 stay free on either side.
    const PictureView view = fitted({800, 600}, 500, 500);
    CHECK(view.zoom == doctest::Approx(1.2));
    CHECK(view.origin.x == doctest::Approx(100));
    CHECK(view.origin.y == doctest::Approx(0));
}

TEST_CASE("A picture opens one to one or by a whole number, on whole pixels of the screen") {
    // Into 800 × 601: 1.2 → 1, (800 − 500)/2 = 150, (601 − 500)/2 = 50.5 → 51; 160 × 80 fits 5 times; 200 × 150 4
    // times.
    const PictureView once = fitted_by_whole_multiple({800, 601}, 500, 500);
    CHECK(once.zoom == 1);
    CHECK(once.origin.x == 150);
    CHECK(once.origin.y == 51);
    CHECK(fitted_by_whole_multiple({800, 600}, 160, 80).zoom == 5);
    CHECK(fitted_by_whole_multiple({800, 600}, 200, 150).zoom == 4);
    // Too large: as large as fits, 800/1000.
    CHECK(fitted_by_whole_multiple({800, 600}, 1000, 500).zoom == doctest::Approx(.8));
}

TEST_CASE("A point of the screen lies on the pixel that is drawn there") {
    const PictureView view{8, {100, 40}};
    CHECK(view.pixel_at({100, 40}) == Pixel{0, 0});
    CHECK(view.pixel_at({107.9, 47.9}) == Pixel{0, 0});
    CHECK(view.pixel_at({108, 40}) == Pixel{1, 0});
    CHECK(view.pixel_at({99.9, 40}) == Pixel{-1, 0});  // beside the picture: rounded down, not towards 0
    CHECK(view.pixel_at({1e300, -1e300}) == Pixel{1'000'000'000, -1'000'000'000});
}

TEST_CASE("What is under the cursor stays there as the wheel turns") {
    const Point cursor{310, 222};
    PictureView view{3, {-17, 5}};
    const Point held = view.on_picture(cursor);
    for (const double factor : {1.25, 1.25, 0.5, 4.0, 0.1}) {
        view = zoomed_at(view, factor, cursor);
        CHECK(view.on_picture(cursor).x == doctest::Approx(held.x));
        CHECK(view.on_picture(cursor).y == doctest::Approx(held.y));
    }
    // 3 × 1.25 × 1.25 × 0.5 × 4 × 0.1
    CHECK(view.zoom == doctest::Approx(0.9375));
}

TEST_CASE("Zoom has ends") {
    const PictureView view{1, {0, 0}};
    CHECK(zoomed_at(view, 1e9, {0, 0}).zoom == greatest_zoom);
    CHECK(zoomed_at(view, 1e-9, {0, 0}).zoom == least_zoom);
}

TEST_CASE("A picture cannot be dragged out of sight") {
    // 100 pixels at zoom 2 are 200 on the screen; 32 of them stay in the area of 400.
    const PictureView far_left = kept_in_sight({2, {-5000, 0}}, {400, 400}, 100, 100);
    CHECK(far_left.origin.x == doctest::Approx(32 - 200));
    const PictureView far_right = kept_in_sight({2, {5000, 0}}, {400, 400}, 100, 100);
    CHECK(far_right.origin.x == doctest::Approx(400 - 32));
    const PictureView inside = kept_in_sight({2, {50, 60}}, {400, 400}, 100, 100);
    CHECK(inside.origin.x == 50);
    CHECK(inside.origin.y == 60);
}

TEST_CASE("Showing a pixel moves the picture as little as it must") {
    const PictureView view{10, {0, 0}};
    CHECK(showing(view, {5, 5}, {100, 100}).origin.x == 0);
    // Pixel 12 covers 120 to 130: 30 too far to the right of an area of 100.
    CHECK(showing(view, {12, 5}, {100, 100}).origin.x == doctest::Approx(-30));
    // Pixel −2 would start at −20.
    CHECK(showing(view, {-2, 5}, {100, 100}).origin.x == doctest::Approx(20));
}
