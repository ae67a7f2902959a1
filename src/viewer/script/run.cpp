#include <algorithm>
#include <utility>

#include "output/output_file.hpp"
#include "viewer/hidden_viewer.hpp"
#include "viewer/script/script.hpp"

namespace glassbox::script {

namespace {

/// What each command does.
struct Performer {
    HiddenViewer& viewer;

    void operator()(const ChangeState& command) const {
        command.change(viewer.state(), viewer.results());
        viewer.settle();
    }
    void operator()(const PressKey& command) const {
        viewer.frame({}, {&command.press, 1});
        viewer.settle();
    }
    void operator()(const ResizeTo& command) const {
        viewer.resize(command.size);
        viewer.settle();
    }
    void operator()(const Wait& command) const {
        constexpr double frame = 1.0 / 30;
        for (double left = command.seconds; left > 0; left -= frame) viewer.frame({}, {}, std::min(left, frame));
    }
    void operator()(const Screenshot& command) const { write_picture(command.file, viewer.screen().screenshot(), {}); }
};

}  // namespace

void run(ViewerState state, std::span<const Command> commands, WindowSize size) {
    HiddenViewer viewer(std::move(state), size);
    viewer.settle();
    for (const Command& command : commands) std::visit(Performer{viewer}, command);
}

}  // namespace glassbox::script
