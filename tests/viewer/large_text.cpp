// Text made larger, for a projector: what is being read stays in sight.
#include <doctest.h>

#include <algorithm>
#include <string>
#include <utility>

#include "viewer/hidden_viewer.hpp"
#include "viewer/model/state/keys.hpp"

using namespace glassbox;

namespace {

/// How many pixels have the colour of the row that is chosen.
std::size_t in_chosen_row(const HiddenViewer& viewer) {
    const Image picture = viewer.screen().screenshot();
    return static_cast<std::size_t>(std::ranges::count(picture.pixels, Rgb{34, 50, 74}));
}

}  // namespace

// The list shows some four rows of 1391 (docs/viewer.md, Steps): a step far down is in it only if the list has
// followed. A row, as wide as the page, which is a quarter of the window at least, and 12 pixels high at least, has
// the colour of the chosen one where no letter lies, at least on the half of it: 1024 / 4 * 12 / 2 = 1536 pixels.
TEST_CASE("the present step stays in sight while text gets larger and smaller, in a small window, too") {
    ViewerState state = opened(std::string(SCENES "/room.toml"));
    state.pinned = Pixel{330, 200};
    state.page = Page::steps;
    HiddenViewer viewer(std::move(state), {1024, 640});
    viewer.settle();
    viewer.state().step = 700;
    viewer.settle();
    CHECK(in_chosen_row(viewer) > 1536);
    const auto press = [&](char32_t character) {
        const KeyPress key{Key::character, character, true, false};
        viewer.frame({}, std::span(&key, 1));
        viewer.settle();
        viewer.frame();
    };
    while (viewer.state().appearance.text_size < 48) {
        press('+');
        CAPTURE(viewer.state().appearance.text_size);
        CHECK(viewer.state().step == 700);
        CHECK(in_chosen_row(viewer) > 1536);
    }
    while (viewer.state().appearance.text_size > 18) {
        press('-');
        CAPTURE(viewer.state().appearance.text_size);
        CHECK(in_chosen_row(viewer) > 1536);
    }
}
