// The surface that is lit up has an outline in the picture: that of the present step, and the one under the mouse.
#include <doctest.h>

#include <algorithm>
#include <cmath>

#include "viewer/hidden_viewer.hpp"
#include "viewer/model/overlay/surfaces_in_picture.hpp"

using namespace glassbox;

namespace {

std::ptrdiff_t outlined(const HiddenViewer& viewer) {
    return std::ranges::count(viewer.screen().screenshot().pixels, Rgb{255, 205, 60});
}

}  // namespace

// Sphere 0 is about column 350 and row 350, pixel (350, 149), with a radius of 50. Its outline is as long as a square
// about it, 400 of the picture's pixels, less what the other sphere hides; half of it must be seen unblended.
TEST_CASE("the present step's surface is outlined where the picture shows it, and another page has no outline") {
    ViewerState state = opened(std::string(SCENES "/levental-2014.toml"));
    state.pinned = Pixel{350, 149};
    HiddenViewer viewer(std::move(state), {1280, 800});
    viewer.settle();
    CHECK(outlined(viewer) == 0);
    CHECK_FALSE(viewer.results().surfaces);  // not asked for, so not measured
    viewer.state().page = Page::steps;
    viewer.state().step = 20;
    viewer.settle();
    viewer.frame();
    const SurfacesInPicture* const seen = surfaces_in_picture(viewer.state(), viewer.results());
    REQUIRE(seen);
    CHECK(seen->numbers.at({350, 149}) == 0);
    CHECK(std::isnan(seen->numbers.at({10, 10})));
    CHECK(outlined(viewer) > 200);
    viewer.state().page = Page::inspector;
    viewer.settle();
    viewer.frame();
    CHECK(outlined(viewer) == 0);
    viewer.state().pointing_at = 0;  // as a row of the inspector does under the mouse
    viewer.frame();
    CHECK(outlined(viewer) > 200);
}
