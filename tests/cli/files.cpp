// Files that cannot be read or written: exit status 1, one line with the place, and nothing written, nothing lost.
#include <doctest.h>
#include <unistd.h>

#include "cli/program.hpp"
#include "cli/tiny_scene.hpp"

using namespace glassbox::test;

namespace {

namespace fs = std::filesystem;

constexpr const char* header = "ox,oy,oz,dx,dy,dz";

/// A folder with a scene, rays, a directory and a binary file.
struct Workplace : Folder {
    Workplace() {
        write(*this / "s.toml", tiny_scene);
        write(*this / "r.csv", std::string(header) + "\n500,1,1,-1,0,0\n");
        write(*this / "binary", std::string("GIF89a\0\1\2", 9));
        fs::create_directory(*this / "directory");
    }
};

/// Checks that `shoot` refuses rays with this text.
void check_rays_refused(const std::string& rays, const std::vector<std::string>& parts) {
    const Workplace folder;
    write(folder / "bad.csv", rays);
    CAPTURE(rays);
    check_refused(folder, {"shoot", "s.toml", "--rays", "bad.csv", "--out", "h.csv"}, 1, parts);
    check_refused(folder, {"shoot", "s.toml", "--rays", "bad.csv"}, 1, parts);
}

/// Checks that `shoot` refuses rays whose second line is this.
void check_row_refused(const std::string& row, const std::vector<std::string>& parts) {
    check_rays_refused(std::string(header) + "\n" + row + "\n", parts);
}

}  // namespace

TEST_CASE("a picture with a single pixel to click on") {
    const Workplace folder;
    write(folder / "narrow.toml", "[image]\nwidth = 1\nheight = 9\n");
    check_refused(folder, {"view", "narrow.toml", "--bench"}, 2, {"--bench: needs a picture two pixels wide or more"});
}

TEST_CASE("a scene that cannot be read") {
    const Workplace folder;
    const auto check = [&](const std::string& scene, const std::vector<std::string>& parts) {
        check_refused(folder, {"render", scene, "-o", "o.png"}, 1, parts);
        check_refused(folder, {"measure", scene, "--what", "depth", "-o", "o.csv"}, 1, parts);
        check_refused(folder, {"shoot", scene, "--rays", "r.csv", "--out", "h.csv"}, 1, parts);
    };
    check("nowhere/s.toml", {"nowhere/s.toml: error: there is no such file", "'levental-2014'"});
    check("lvental-2014", {"lvental-2014: error: there is no such file; did you mean 'levental-2014'?"});
    check("scenes/romo.toml", {"did you mean 'room'?"});
    check("", {"\"\": error: there is no such file"});
    check("directory", {"directory: error: it is a directory, not a file"});
    check("binary", {"binary: error: this is a binary file; it must be a text file"});
    check("two\nlines", {"two?lines: error: there is no such file"});
    write(folder / "latin-1.toml", "title = \"\xe9\"");
    check("latin-1.toml", {"latin-1.toml:1:", "error: this is not UTF-8"});
    write(folder / "typo.toml", "[[sphere]]\ncenter = [0, 0, 0]\nradus = 1\n");
    check("typo.toml", {"typo.toml:3:1: error: unknown key 'radus'", "did you mean 'radius'?"});
    write(folder / "mesh.toml", "[[mesh]]\nfile = \"none.obj\"\n");
    check("mesh.toml", {"mesh.toml:2:", "none.obj"});
}

TEST_CASE("an output that cannot be written") {
    const Workplace folder;
    const auto check = [&](const std::string& command, const std::string& out, const std::vector<std::string>& parts) {
        if (command == "render") check_refused(folder, {"render", "s.toml", "-o", out}, 1, parts);
        if (command == "measure") check_refused(folder, {"measure", "s.toml", "--what", "hits", "-o", out}, 1, parts);
        if (command == "shoot") check_refused(folder, {"shoot", "s.toml", "--rays", "r.csv", "-o", out}, 1, parts);
    };
    for (const char* command : {"render", "measure", "shoot"}) {
        check(command, "nowhere/o.png", {"nowhere/o.png: error: cannot write", "create the folder nowhere/ first"});
        check(command, "directory", {"directory: error: cannot write", "name a file in it"});
        check(command, "directory/", {"directory/: error: cannot write", "name a file in it"});
        check(command, "s.toml/o.png", {"s.toml/o.png: error: cannot write", "s.toml is not a folder"});
        check(command, std::string(300, 'a') + ".png", {"error: cannot write", "choose a shorter name"});
        if (fs::exists("/dev/full")) check(command, "/dev/full", {"/dev/full: error: cannot write", "free some space"});
    }
    check("render", "o.jpg", {"o.jpg: error: unknown extension .jpg; use .png or .ppm"});
    check("render", "o", {"o: error: the name has no extension; use .png or .ppm"});
    check("render", "o.csv", {"o.csv: error: unknown extension .csv"});
    check("measure", "o.txt", {"o.txt: error: unknown extension .txt; use .csv, .png, .ppm or .exr"});
}

TEST_CASE("a folder or file that must not be written to" * doctest::skip(::geteuid() == 0)) {
    const Workplace folder;
    fs::permissions(folder / "directory", fs::perms::owner_read | fs::perms::owner_exec);
    check_refused(folder, {"render", "s.toml", "-o", "directory/o.png"}, 1, {"directory/o.png: error: cannot write"});
    fs::permissions(folder / "directory", fs::perms::owner_all);
    fs::permissions(write(folder / "kept.png", "kept"), fs::perms::owner_read);
    check_refused(folder, {"render", "s.toml", "-o", "kept.png"}, 1,
                  {"kept.png: error: cannot write", "allow writing"});
}

TEST_CASE("what is refused leaves the file of an earlier run as it was") {
    const Workplace folder;
    for (const char* name : {"o.png", "o.csv", "h.csv"}) write(folder / name, "of an earlier run");
    write(folder / "bad.toml", "[image]\nwidth = 0\n");
    check_refused(folder, {"render", "bad.toml", "-o", "o.png"}, 1, {"bad.toml:2:9: error: width is 0"});
    check_refused(folder, {"measure", "bad.toml", "--what", "hits", "-o", "o.csv"}, 1, {"bad.toml:2:9: error"});
    check_refused(folder, {"shoot", "s.toml", "--rays", "s.toml", "-o", "h.csv"}, 1, {"s.toml:1:1: error"});
    check_refused(folder, {"render", "s.toml", "-o", "o.png", "--size", "0x0"}, 2, {"--size"});
}

TEST_CASE("hits do not take the place of the rays or of the scene") {
    const Workplace folder;
    fs::create_symlink("r.csv", folder / "link.csv");
    for (const char* out : {"r.csv", "s.toml", "./directory/../r.csv", "link.csv"})
        check_refused(folder, {"shoot", "s.toml", "--rays", "r.csv", "--out", out}, 1,
                      {std::string(out) + ": error: this file is read, and would be lost; name another one"});
}

TEST_CASE("rays that are no readable file") {
    const Workplace folder;
    const auto check = [&](const char* rays, const std::vector<std::string>& parts) {
        check_refused(folder, {"shoot", "s.toml", "--rays", rays, "--out", "h.csv"}, 1, parts);
    };
    check("none.csv", {"none.csv: error: there is no such file"});
    check("directory", {"directory: error: it is a directory, not a file"});
    check("binary", {"binary: error: this is a binary file; it must be a text file"});
    check("/dev/null", {"/dev/null:1:1: error: the first line must be the header ox,oy,oz,dx,dy,dz"});
    check("/dev/zero", {"/dev/zero: error: this is a binary file"});
}

TEST_CASE("rays without their header") {
    const std::string right = "bad.csv:1:1: error: the first line must be the header ox,oy,oz,dx,dy,dz";
    for (const char* start : {"", "\n", "1,2,3,4,5,6\n", "ox,oy,oz,dx,dy\n", "ox,oy,oz,dx,dy,dz,w\n",
                              "x,y,z,dx,dy,dz\n", "ox;oy;oz;dx;dy;dz\n", "\nox,oy,oz,dx,dy,dz\n"})
        check_rays_refused(start, {right});
}

TEST_CASE("a row that is not six numbers") {
    check_row_refused("1,2,3,4,5", {"bad.csv:2:9: error: 5 numbers in this row; a ray has 6: ox,oy,oz,dx,dy,dz"});
    check_row_refused("1,2,3,4,5,6,7,8", {"bad.csv:2:13: error: 8 numbers in this row; a ray has 6"});
    check_row_refused("1,2,3,4,5,6,", {"bad.csv:2:13: error: 7 numbers in this row"});
    check_row_refused("1,2,,4,5,6", {"bad.csv:2:5: error: '' is not a number; write one such as 0.5"});
    check_row_refused(",,,,,", {"bad.csv:2:1: error: '' is not a number"});
    check_row_refused("1,2,3,4,5,", {"bad.csv:2:11: error: '' is not a number"});
    check_row_refused("1,2,three,4,5,6", {"bad.csv:2:5: error: 'three' is not a number"});
    check_row_refused("1,2,3,4,5,6 7", {"bad.csv:2:11: error: '6 7' is not a number"});
    check_row_refused("1;2;3;4;5;6", {"bad.csv:2:1: error: '1;2;3;4;5;6' is not a number"});
    check_row_refused("  1,2,\"3\",4,5,6", {"bad.csv:2:7: error: '\"3\"' is not a number"});
    check_row_refused("1,2,3,0x,5,6", {"bad.csv:2:7: error: '0x' is not a number"});
    check_row_refused("1,2,3,1e999,5,6", {"bad.csv:2:7: error: '1e999' is too large for a double; write inf"});
    check_row_refused("1,2,3,4,5,-1e999", {"bad.csv:2:11: error: '-1e999' is too large"});
    check_row_refused("1,2,3,4,5,\x01\xff", {"bad.csv:2:11: error: ", "is not a number"});
    check_row_refused(std::string(100000, 'x'), {"bad.csv:2:1: error: 'xxxx", "…' is not a number"});
    check_row_refused("1,2,3,4,5,6\r\n\r\n1,2,3,4,5\r", {"bad.csv:4:9: error: 5 numbers in this row"});
}

TEST_CASE("scene lists what comes with Glassbox, and copies one to the byte, never over a file that is there") {
    const Workplace folder;
    const auto scene = [&](Arguments arguments) {
        arguments.insert(arguments.begin(), "scene");
        return run_glassbox(arguments, {.folder = folder.path});
    };
    const Ran list = scene({});
    CHECK(list.status == 0);
    CHECK(list.out.find("\nroom             A room with a knot in it\n") != std::string::npos);

    const Ran printed = scene({"sphere"});
    CHECK(printed.status == 0);
    CHECK(printed.err == "");
    CHECK(printed.out.find("[[sphere]]") != std::string::npos);
    CHECK(scene({"sphere", "-o", "ball.toml"}).status == 0);
    CHECK(run_glassbox({"scene", "ball.toml"}, {.folder = folder.path}).out == printed.out);
    CHECK(run_glassbox({"render", "ball.toml", "--size", "4x3"}, {.folder = folder.path}).status == 0);

    const Ran again = scene({"triangle", "-o", "ball.toml"});
    CHECK(again.status == 1);
    CHECK(again.err.starts_with("ball.toml: error: there is a file of that name, which is not replaced"));
    CHECK(run_glassbox({"scene", "ball.toml"}, {.folder = folder.path}).out == printed.out);

    CHECK(scene({"room", "-o", "room.toml"}).err.starts_with("it reads meshes beside it"));
    CHECK(scene({"rom"}).err.find("did you mean 'room'?") != std::string::npos);
    CHECK(scene({"-o", "x.toml"}).status == 2);
    CHECK_FALSE(fs::exists(folder / "x.toml"));
}

TEST_CASE("what is printed to a full or closed stdout is not taken for printed") {
    const Workplace folder;
    const auto check = [&](const Arguments& arguments, const char* out) {
        const Ran ran = run_glassbox(arguments, {.folder = folder.path, .out = out});
        CHECK(ran.status == 1);
        CHECK(ran.err.starts_with("standard output: error: cannot write: "));
    };
    for (const Arguments& arguments :
         {Arguments{"doctor"}, {"--help"}, {"shoot", "s.toml", "--rays", "r.csv"}, {"render", "s.toml"}}) {
        if (fs::exists("/dev/full")) check(arguments, "/dev/full");
        check(arguments, nullptr);
    }
}

TEST_CASE("a full or closed stderr changes no exit status, and nothing in the files") {
    const Workplace folder;
    for (const char* err : {"/dev/full", static_cast<const char*>(nullptr)}) {
        CHECK(run_glassbox({"render", "none.toml"}, {.folder = folder.path, .err = err}).status == 1);
        CHECK(run_glassbox({"render"}, {.folder = folder.path, .err = err}).status == 2);
        const Arguments with_note{"render", "s.toml", "--stage", "2", "--turn", "z:1", "-o", "o.ppm"};
        CHECK(run_glassbox(with_note, {.folder = folder.path, .in = nullptr, .out = nullptr, .err = err}).status == 0);
        CHECK(without_comments(content(folder / "o.ppm")).size() == 11 + 4 * 3 * 3);
    }
}
