#include "viewer/hidden_viewer.hpp"

#include <chrono>
#include <thread>
#include <utility>

namespace glassbox {

HiddenViewer::HiddenViewer(ViewerState state, WindowSize size)
    : screen_(size), interface_(std::move(state), 1, [] {}) {}

void HiddenViewer::frame(const Pointer& pointer, std::span<const KeyPress> keys, double seconds) {
    interface_.prepare();
    screen_.frame([&](const Input& input) { return interface_.draw(input); }, pointer, keys, seconds);
}

void HiddenViewer::settle() {
    constexpr int frames_to_lay_out = 4;  // Dear ImGui places some things by what it measured in the frame before
    for (int quiet = 0; quiet < frames_to_lay_out;) {
        frame();
        quiet = settled() ? quiet + 1 : 0;
        if (quiet == 0) std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
}

}  // namespace glassbox
