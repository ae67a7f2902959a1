// `glassbox explain`, run as users run it.
#include <doctest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "cli/program.hpp"
#include "cli/tiny_scene.hpp"
#include "scene/printable.hpp"

using namespace glassbox::test;

TEST_CASE("text and JSON on stdout") {
    const Folder folder;
    write(folder / "s.toml", tiny_scene);
    const Ran text = run_glassbox({"explain", "s.toml", "--pixel", "1,1"}, {.folder = folder.path});
    CHECK(text.status == 0);
    CHECK(text.err == "");
    CHECK(text.out.find("\nPixel (1, 1) of 4 × 3") != std::string::npos);
    CHECK(text.out.find("glassbox explain s.toml --pixel 1,1\n") != std::string::npos);
    const Ran json = run_glassbox({"explain", "s.toml", "--pixel", "1,1", "--json"}, {.folder = folder.path});
    CHECK(json.status == 0);
    CHECK(nlohmann::json::parse(json.out)["hit"]["t"]["value"] == 499);
}

TEST_CASE("the command in a story tells the same story again") {
    const Folder folder;
    write(folder / "two words.toml", tiny_scene);
    const Ran ran = run_glassbox({"explain", "two words.toml", "--pixel", "2,1", "--turn", "z:1,y:-2", "--size=8x6",
                                  "--diffuse", ".5", "--triangle", "tolerance:3", "--json"},
                                 {.folder = folder.path});
    CHECK(ran.status == 0);
    const std::string command = nlohmann::json::parse(ran.out)["command"];
    CHECK(command.starts_with("glassbox explain 'two words.toml'"));
    for (const char* part : {"--pixel 2,1", "--turn z:1,y:-2", "--size 8x6", "--diffuse 0.5", "--triangle tolerance:3"})
        CHECK_MESSAGE(command.find(part) != std::string::npos, part);
    CHECK(command.find("json") == std::string::npos);
}

TEST_CASE("a title, a file's name and what they hold do not command the terminal") {
    const Folder folder;
    // Escape and a colour, a C1 code, a right-to-left override, a newline, and in the name a byte of Latin-1.
    const std::string scene = std::string("title = \"a\\u001b[31mb\\u009b31mc\\u202Ed\\ne\"\n") + tiny_scene;
    const std::string name = "a\x1b[31m'b\xe9.toml";
    write(folder / name, scene);
    const Ran text = run_glassbox({"explain", name, "--pixel", "1,1"}, {.folder = folder.path});
    CHECK(text.status == 0);
    CHECK(text.out.find("\n  a?[31mb?31mc?d?e\n") != std::string::npos);
    // 27 is 033 in octal, and 0xe9 is 351.
    CHECK(text.out.find("glassbox explain $'a\\033[31m\\'b\\351.toml' --pixel 1,1\n") != std::string::npos);
    CHECK(text.out == glassbox::printable_lines(text.out));

    const Ran json = run_glassbox({"explain", name, "--pixel", "1,1", "--json"}, {.folder = folder.path});
    CHECK(json.status == 0);
    CHECK(json.out == glassbox::printable_lines(json.out));
    CHECK(nlohmann::json::parse(json.out)["title"] == "a\x1b[31mb\u009b31mc\u202Ed\ne");
}

TEST_CASE("pixels that are none") {
    const Folder folder;
    write(folder / "s.toml", tiny_scene);
    const auto refused = [&](const char* pixel, const std::vector<std::string>& parts) {
        check_refused(folder, {"explain", "s.toml", "--pixel", pixel}, 2, parts);
    };
    refused("4,0", {"glassbox explain: error: --pixel: '4,0': x must be a whole number from 0 to 3", "4x3"});
    refused("0,3", {"y must be a whole number from 0 to 2"});
    refused("-1,0", {"x must be a whole number from 0 to 3"});
    refused("1.5,0", {"x must be a whole number"});
    refused("1", {"'1' must be X,Y"});
    refused("1,2,3", {"'1,2,3' must be X,Y"});
    refused("", {"'' must be X,Y"});
    check_refused(folder, {"explain", "s.toml"}, 2, {"--pixel is missing"});
}

// The ray of column 1 goes through the ball's middle: a hit, Δ = 1. The answers come from a file, and are shown.
TEST_CASE("predict first, with answers from a file") {
    const Folder folder;
    write(folder / "s.toml", tiny_scene);
    const std::string answers = write(folder / "answers", "h\n+\n").string();
    const Ran ran = run_glassbox({"explain", "s.toml", "--pixel", "1,1", "--predict"},
                                 {.folder = folder.path, .in = answers.c_str()});
    CHECK(ran.status == 0);
    CHECK(ran.err == "");
    CHECK(ran.out.find("surface 0, sphere about (0, 1, 1), radius 1: hit or miss? (h or m) h\n") != std::string::npos);
    CHECK(ran.out.find("which sign? (+, - or 0) +\n  right: Δ = 1\n") != std::string::npos);
    CHECK(ran.out.ends_with("\n1 of 1 right\n"));  // the verdict comes after a question that nobody answered
    check_refused(folder, {"explain", "s.toml", "--pixel", "1,1", "--predict", "--json"}, 2, {"--predict", "--json"});
}
