#include "cli/commands.hpp"
#include "scene/error.hpp"

namespace glassbox {

// Compiled instead of view.cpp if the viewer's libraries are missing.
void add_view(CLI::App& program, Session&) {
    CLI::App* command = program.add_subcommand("view", "Open the viewer (not in this build)");
    command->allow_extras();
    command->callback([] {
        throw Error(
            "glassbox view: error: this program was built without the viewer; install libglfw3-dev, libimgui-dev, "
            "libegl-dev, libgl-dev and libopengl-dev, or what your system calls them, and build again. Without it: "
            "render, measure "
            "and explain tell the same");
    });
}

}  // namespace glassbox
