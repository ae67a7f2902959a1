// Dragging over the picture: what turns the view, what moves the picture, and what is a click.
#include <doctest.h>

#include "viewer/hidden_viewer.hpp"

using namespace glassbox;

namespace {

/// A viewer whose picture, of a pixel a pixel of the screen, is pressed with a button at a place in its middle.
struct Pressed {
    HiddenViewer viewer{opened(std::string(SCENES "/levental-2014.toml")), {1280, 800}};
    Pointer pointer{300, 250};
    bool Pointer::*button;

    explicit Pressed(bool Pointer::*its_button) : button(its_button) {
        viewer.settle();
        REQUIRE(viewer.state().view.zoom == 1);
        viewer.frame(pointer);
        pointer.*button = true;
        viewer.frame(pointer);
    }
    void drag(float by) {
        pointer.x += by;
        viewer.frame(pointer);
    }
    void release() {
        pointer.*button = false;
        viewer.frame(pointer);
        viewer.settle();
    }
    const std::vector<Turn<double>>& turns() { return viewer.state().setup.now().options.turns; }
};

}  // namespace

// Half a turn for the picture's width, 500: 50 pixels are 18 degrees.
TEST_CASE("a drag with the right button turns the view, at each step; undo takes all of it back") {
    Pressed mouse(&Pointer::right);
    for (int i = 1; i <= 5; ++i) {
        mouse.drag(10);
        if (i < 2) continue;  // what could still become a click
        REQUIRE(mouse.turns().size() == 1);
        CHECK(mouse.turns().front().axis == Axis::z);
        CHECK(mouse.turns().front().degrees == doctest::Approx(-std::round(3.6 * i)));
    }
    const std::uint64_t before = mouse.viewer.results().picture_serial;
    mouse.release();
    CHECK(mouse.viewer.results().picture_serial > before);
    CHECK(mouse.viewer.results().picture.factor == 1);
    CHECK_FALSE(mouse.viewer.state().pinned);
    mouse.viewer.state().setup.undo();
    CHECK(mouse.turns().empty());
}

TEST_CASE("a click pins a pixel; a drag does not, even where it comes back") {
    Pressed click(&Pointer::left);
    click.drag(1);  // a hand is never quite still
    click.release();
    CHECK(click.viewer.state().pinned);
    Pressed there_and_back(&Pointer::left);
    there_and_back.drag(50);
    there_and_back.drag(-50);
    there_and_back.release();
    CHECK_FALSE(there_and_back.viewer.state().pinned);
}
