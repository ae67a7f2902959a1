#include <doctest.h>

#include <array>
#include <fstream>
#include <random>
#include <utility>

#include "../output/folder.hpp"
#include "render/measure/measurements.hpp"
#include "viewer/hidden_viewer.hpp"
#include "viewer/model/state/keys.hpp"

using namespace glassbox;

namespace {

constexpr const char* good_scene = R"(
title = "Random"
[image]
width = 60
height = 40
[view]
corner = [500, 0, 0]
[[sphere]]
center = [100, 30, 20]
radius = 15
color = [0, 255, 0]
[[triangle]]
vertices = [[50, 0, 0], [50, 40, 0], [50, 0, 40]]
color = [128, 128, 128]
)";

/// A user who knows nothing of the interface, and is fast.
class Monkey {
public:
    explicit Monkey(HiddenViewer& viewer, const std::filesystem::path& scene) : viewer_(viewer), scene_(scene) {}

    /// One input: a key, a click, a part of a drag, a turn of the wheel, another size, a changed scene file.
    void act() {
        const int what = number(0, 999);
        if (what < 500) {
            pointer_.x = static_cast<float>(number(-20, viewer_.screen().size().width + 20));
            pointer_.y = static_cast<float>(number(-20, viewer_.screen().size().height + 20));
            viewer_.frame(pointer_);
        } else if (what < 700) {
            pointer_.left = !pointer_.left;
            viewer_.frame(pointer_);
        } else if (what < 740) {
            pointer_.right = !pointer_.right;
            viewer_.frame(pointer_);
        } else if (what < 800) {
            Pointer turned = pointer_;
            turned.wheel = static_cast<float>(number(-5, 5));
            viewer_.frame(turned);
        } else if (what < 980) {
            const auto bindings = key_bindings();
            KeyPress press = bindings[static_cast<std::size_t>(number(0, static_cast<int>(bindings.size()) - 1))].press;
            if (number(0, 9) == 0) press.character = static_cast<char32_t>(number(32, 0x2fff));
            viewer_.frame(pointer_, {&press, 1});
        } else if (what < 990) {
            viewer_.resize({number(64, 800), number(64, 500)});
        } else if (what < 995) {
            const auto all = measurements();
            viewer_.state().overlay.measurement =
                all[static_cast<std::size_t>(number(0, static_cast<int>(all.size()) - 1))].name;
        } else {
            std::ofstream(scene_) << (number(0, 1) == 0 ? good_scene : "[image\nwidth = -");
            reload(viewer_.state());
        }
    }

private:
    int number(int least, int most) { return std::uniform_int_distribution(least, most)(random_); }

    HiddenViewer& viewer_;
    std::filesystem::path scene_;
    Pointer pointer_;
    std::mt19937 random_{20141122};  // any number: the same each time, so that what fails can be found
};

#ifdef GLASSBOX_SANITIZED
constexpr int inputs = 4'000;  // checked code is slow
#else
constexpr int inputs = 10'000;
#endif

}  // namespace

TEST_CASE("Random inputs by the thousand: no crash, no leak, no complaint from OpenGL") {
    const test::Folder folder;
    const std::filesystem::path scene = folder.path / "random.toml";
    std::ofstream(scene) << good_scene;
    std::filesystem::current_path(folder.path);  // it saves files, too
    ViewerState state = opened(scene);
    state.mine.folder = folder.path / "my";  // nobody's code
    HiddenViewer viewer(std::move(state), {640, 400});
    Monkey monkey(viewer, scene);
    for (int i = 0; i < inputs; ++i) monkey.act();
    viewer.resize({1024, 640});
    viewer.settle();
    CHECK(viewer.screen().complaints() == 0);
    CHECK(viewer.results().picture.image != nullptr);
}
