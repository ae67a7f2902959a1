// Each file that `render` and `measure` write says by which command the same bytes are made again.
#include <doctest.h>

#include <cstdlib>

#include "cli/program.hpp"
#include "cli/tiny_scene.hpp"
#include "output/command_in.hpp"

using namespace glassbox::test;

namespace {

/// The command in a file, found by what stands around it: a PNG's keyword and length, an EXR's attribute and length, a
/// PPM's line.
std::string command_in(const std::string& file) {
    const auto bytes = [&](std::size_t at, bool first_is_low) {
        std::size_t number = 0;
        for (std::size_t i = 0; i < 4; ++i)
            number |= std::size_t{static_cast<unsigned char>(file.at(at + i))} << 8 * (first_is_low ? i : 3 - i);
        return number;
    };
    if (const std::size_t at = file.find(std::string("tEXtCommand\0", 12)); at != std::string::npos)
        return file.substr(at + 12, bytes(at - 4, false) - 8);
    if (const std::size_t at = file.find(std::string("iTXtCommand\0\0\0\0\0", 16)); at != std::string::npos)
        return file.substr(at + 16, bytes(at - 4, false) - 12);
    if (const std::size_t at = file.find(std::string("command\0string\0", 15)); at != std::string::npos)
        return file.substr(at + 19, bytes(at + 15, true));
    const std::size_t at = file.find("\n# Command: ");
    REQUIRE(at != std::string::npos);
    return file.substr(at + 12, file.find('\n', at + 1) - at - 12);
}

/// Runs the arguments, and then, in the same folder through a shell, the command that the file has.
void check_made_again(const Folder& folder, Arguments arguments, const std::string& name) {
    arguments.insert(arguments.end(), {"-o", name});
    const Ran ran = run_glassbox(arguments, {.folder = folder.path});
    CAPTURE(ran.err);
    REQUIRE(ran.status == 0);
    const std::string made = content(folder / name);
    const std::string command = command_in(made);
    CAPTURE(command);
    REQUIRE(command.starts_with("glassbox "));
    CHECK(run_glassbox({"again", name}, {.folder = folder.path}).out == command + '\n');
    std::filesystem::remove(folder / name);
    const std::string line = "cd '" + folder.path.string() + "' && '" GLASSBOX_PROGRAM "' " + command.substr(9);
    REQUIRE(std::system(line.c_str()) == 0);
    std::string again = command.substr(command.rfind(" -o ") + 4);
    if (again.starts_with('\'')) again = again.substr(1, again.size() - 2);
    CHECK(content(folder / again) == made);
}

}  // namespace

TEST_CASE("the command in a file makes the same bytes again, whatever was asked for and however the files are named") {
    const Folder folder;
    for (const char* name : {"s.toml", "two words.toml", "schön.toml", "-s.toml"}) write(folder / name, tiny_scene);
    const Arguments changed{"--size",    "8x6",   "--turn=z:10,y:-.1", "--accumulated", "--ambient", ".3",
                            "--scalar",  "float", "--sphere",          "textbook",      "--light",   "1e3,-.25,7",
                            "--threads", "2"};
    for (const char* scene : {"s.toml", "two words.toml", "schön.toml", "./-s.toml", "room"})
        for (const char* extension : {".png", ".ppm", ".exr", ".PNG"}) {
            const bool exr = std::string(extension) == ".exr";
            Arguments arguments{exr ? "measure" : "render", scene};
            if (exr) arguments.insert(arguments.end(), {"--what", "depth,n.l"});
            arguments.insert(arguments.end(), changed.begin(), changed.end());
            check_made_again(folder, arguments, std::string("any") + extension);
        }
    check_made_again(folder, {"measure", "s.toml", "--what", "verdict,depth", "--triangle", "tolerance:0.1"}, "m.png");
    check_made_again(folder, {"measure", "s.toml", "--what", "hits"}, "m.ppm");
    check_made_again(folder, {"measure", "s.toml", "--what", "hits,depth", "--scale", "symlog"}, "m.png");
    check_made_again(folder,
                     {"measure", "s.toml", "--what", "hits,depth", "--sphere", "levental-2014", "--minus",
                      "sphere:stable,turn:z:0.1,y:0.1", "--scale", "linear"},
                     "m.png");
}

TEST_CASE("the bytes do not depend on the file's name, nor on the number of threads") {
    const Folder folder;
    write(folder / "s.toml", tiny_scene);
    std::filesystem::create_directory(folder / "elsewhere");
    run_glassbox({"render", "s.toml", "-o", "a.png"}, {.folder = folder.path});
    run_glassbox({"render", "s.toml", "-o", "elsewhere/b.png", "--threads", "3"}, {.folder = folder.path});
    CHECK(content(folder / "a.png") == content(folder / "elsewhere/b.png"));
    CHECK(command_in(content(folder / "a.png")) == "glassbox render s.toml -o s.png");
}

TEST_CASE("again: what has no command, or is cut off, says so") {
    const Folder folder;
    write(folder / "s.toml", tiny_scene);
    for (const char* name : {"a.png", "a.ppm"}) run_glassbox({"render", "s.toml", "-o", name}, {.folder = folder.path});
    run_glassbox({"measure", "s.toml", "--what", "hits", "-o", "a.exr"}, {.folder = folder.path});
    for (const char* name : {"a.png", "a.ppm", "a.exr"}) {
        const std::string whole = content(folder / name);
        for (std::size_t size = 0; size < whole.size(); ++size) {  // never beyond its end
            if (size > 400) break;
            const std::string part = glassbox::command_in(whole.substr(0, size));
            CHECK_MESSAGE(command_in(whole).starts_with(part), name);
        }
    }
    for (const std::string text : {"", "P6\n# no newline", "\x89PNG\r\n\x1a\n\xff\xff\xff\xfftEXtCommand"}) {
        write(folder / "bad.png", text);
        check_refused(folder, {"again", "bad.png"}, 1, {"bad.png: error: it says no command"});
    }
    check_refused(folder, {"again", "s.toml"}, 1, {"s.toml: error: it says no command"});
    check_refused(folder, {"again", "none.png"}, 1, {"none.png: error: there is no such file"});
    check_refused(folder, {"again"}, 2, {"FILE is missing"});
}

TEST_CASE("a table stays as it is") {
    const Folder folder;
    write(folder / "s.toml", tiny_scene);
    run_glassbox({"measure", "s.toml", "--what", "hits", "-o", "m.csv"}, {.folder = folder.path});
    CHECK(content(folder / "m.csv").starts_with("x,y,hits\n0,0,0\n"));
}
