#include "learn/picture/learners_picture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>

#include "learn/build/compile_error.hpp"
#include "learn/check/test_run.hpp"
#include "scene/error.hpp"
#include "scene/printable.hpp"
#include "scene/text_file.hpp"

namespace glassbox::learn {
namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;

constexpr int largest_side = 16384;

/// Returns in words how a program ended that wrote no picture.
std::string end_of(const Outcome& outcome) {
    const std::string text = outcome.last_words.kind == LastWords::threw ? outcome.last_words.text : "";
    if (!function_not_written(text).empty()) return printable(text);
    std::string words = how_it_ended(outcome);
    if (words.empty() && outcome.last_words.kind != LastWords::finished) words = "it ended before its work was done";
    return words;
}

/// The lines of a text, each once, in the order in which they first come.
std::vector<std::string> unlike_lines(const std::string& text) {
    std::vector<std::string> lines;
    for (const std::string_view line : lines_of(text))
        if (std::find(lines.begin(), lines.end(), line) == lines.end()) lines.emplace_back(line);
    return lines;
}

/// Where a lesson's program is made, and from what.
struct Making {
    fs::path headers, object, program;
};

std::optional<CompileError> build(const Workspace& workspace, const Exercise& exercise, const Toolchain& tools,
                                  const Making& making, const std::stop_token& stop) {
    const Compilation what{exercise.lesson / "main.cpp",
                           making.object,
                           includes_of(workspace, exercise, making.headers),
                           {"-O1", "-g0", "-Werror=return-type", "-Dmain=lesson_main"},
                           workspace.root};
    if (auto error =
            compile_error(compile(tools.compiler, what, stop), own_headers(exercise, making.headers), workspace.root))
        return error;
    return link_error(link(tools.compiler, {making.object, tools.picture_main}, making.program, tools.linker, stop));
}

}  // namespace

Image read_ppm(const fs::path& file) {
    std::error_code none;
    if (!fs::is_regular_file(fs::symlink_status(file, none)))
        throw error_at({file.string()}, "there is no picture, or no plain file");
    std::ifstream in(file, std::ios::binary);
    std::string magic;
    int width = 0, height = 0, most = 0;
    in >> magic >> width >> height >> most;
    const bool good = in && magic == "P6" && width > 0 && height > 0 && most == 255 && width <= largest_side &&
                      height <= largest_side && in.get() != std::char_traits<char>::eof();
    if (!good) throw error_at({file.string()}, "this is not a picture in PPM's binary form, P6, with bytes up to 255");
    Image image(width, height);
    static_assert(sizeof(Rgb) == 3);
    const auto bytes = static_cast<std::streamsize>(image.pixels.size() * sizeof(Rgb));
    if (!in.read(reinterpret_cast<char*>(image.pixels.data()), bytes))
        throw error_at({file.string()},
                       fmt::format("the picture ends early: {}x{} pixels are {} bytes", width, height, bytes));
    return image;
}

LessonPicture lesson_picture(const Workspace& workspace, const Exercise& exercise, const Toolchain& tools,
                             const fs::path& headers, const fs::path& folder, const std::stop_token& stop) {
    const Making making{headers, folder / "picture.o", folder / "picture-program"};
    const fs::path ppm = folder / "picture-run" / "picture.ppm";
    LessonPicture picture;
    picture.error = build(workspace, exercise, tools, making, stop);
    if (picture.error && !stop.stop_requested())
        picture.error = with_its_cause(*picture.error, [&] {
            const fs::path ours = make_folder(folder / "ours");
            return build(workspace, exercise, tools,
                         {workspace.solutions_of(exercise), ours / "picture.o", ours / "picture-program"}, stop);
        });
    if (picture.error) return picture;

    Command command{making.program, {ppm.string()}};
    command.folder = new_folder(ppm.parent_path());
    command.limits = {.time = 20s, .memory = std::uint64_t{1} << 30, .file = std::uint64_t{64} << 20};
    if (tools.compiler.isolation) command.isolation = Isolation{{folder}, {command.folder}};
    const Outcome outcome = run(command, stop);
    picture.died = end_of(outcome);
    picture.said = unlike_lines(printable_lines(outcome.errors));
    if (!picture.died.empty()) {
        check_room(command.folder);
        return picture;
    }
    try {
        picture.image = read_ppm(ppm);
    } catch (const Error& error) {
        picture.died = error.what();
    }
    return picture;
}

}  // namespace glassbox::learn
