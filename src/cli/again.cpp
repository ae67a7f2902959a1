#include <fstream>
#include <memory>
#include <string>

#include "cli/commands.hpp"
#include "cli/tell.hpp"
#include "output/command_in.hpp"
#include "scene/error.hpp"
#include "scene/text_file.hpp"

namespace glassbox {

namespace {

/// A file's beginning, in which its origin stands. Throws Error.
std::string beginning(const std::string& file) {
    if (const auto why = why_unreadable(file)) throw error_at({file}, *why);
    constexpr std::size_t enough = 1 << 26;
    std::string bytes(enough, '\0');
    std::ifstream in(file, std::ios::binary);
    in.read(bytes.data(), static_cast<std::streamsize>(enough));
    bytes.resize(static_cast<std::size_t>(in.gcount()));
    return bytes;
}

}  // namespace

void add_again(CLI::App& program) {
    const auto file = std::make_shared<std::string>();
    CLI::App* command = program.add_subcommand(
        "again", "Show the command that made a picture or measurements: it makes the same bytes");
    command->add_option("FILE", *file, "a .png, .ppm or .exr that render, measure or the viewer wrote")
        ->type_name(" ")
        ->required();
    command->footer("Example: glassbox again room.png");
    command->callback([file] {
        const std::string made_by = command_in(beginning(*file));
        if (made_by.empty())
            throw error_at({*file},
                           "it says no command; a .png, .ppm or .exr that render, measure or the viewer wrote does");
        print_text(made_by + '\n');
    });
}

}  // namespace glassbox
