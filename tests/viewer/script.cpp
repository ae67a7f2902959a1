#include <doctest.h>

#include <filesystem>
#include <string>

#include "cli/program.hpp"

using namespace glassbox;

namespace {

const std::filesystem::path scenes = SCENES;

}  // namespace

TEST_CASE("a script names files with blanks, # and quotes in quotes, after a byte order mark, in lines of old Macs") {
    const test::Folder folder;
    std::filesystem::copy_file(scenes / "triangle.toml", folder / "my scene #1.toml");
    std::filesystem::copy_file(scenes / "triangle.toml", folder / "it's.toml");
    test::write(folder / "a.script",
                "\xEF\xBB\xBFopen \"my scene #1.toml\"  # it's a \"comment\"\rsize 500x400\ropen it's.toml\r"
                "open \"it's.toml\"\rscreenshot 'out \"1\" #.png'\r");
    const test::Ran ran = test::run_glassbox({"view", "--script", "a.script"}, {.folder = folder.path});
    CAPTURE(ran.err);
    CHECK(ran.status == 0);
    CHECK(std::filesystem::exists(folder / "out \"1\" #.png"));
}

TEST_CASE("what is wrong with a script's quotes, and with names in them, is told with its place") {
    const test::Folder folder;
    test::write(folder / "open.script", "size 500x400\r\n  open \"my scene\r\n");
    test::check_refused(folder, {"view", "--script", "open.script"}, 1,
                        {"open.script:2:3: error: ", "'\"my scene'", "closed"});
    test::write(folder / "none.script", "open 'no such scene'\n");
    test::check_refused(folder, {"view", "--script", "none.script"}, 1, {"none.script:1:1: error: ", "no such scene"});
    test::write(folder / "lesson.script", "set lesson alll\n");
    test::check_refused(folder, {"view", "--script", "lesson.script"}, 1,
                        {"lesson.script:1:1: error: ", "'alll' must be the number of a lesson, or all"});
    std::string deep = "a";
    for (int k = 0; k < 40000; ++k) deep += ".b";
    deep += " = 1\n";
    test::write(folder / "deep.toml", deep);
    test::write(folder / "deep.script", "open deep.toml\n");
    test::check_refused(folder, {"view", "--script", "deep.script"}, 1,
                        {"deep.script:1:1: error: ", "deep.toml:1:", "100 levels"});
}

TEST_CASE("a script shows a scene fail, finds the worst pixel and brushes values; what it cannot is told") {
    const test::Folder folder;
    const auto run = [&](const std::string& text) {
        test::write(folder / "a.script", text);
        return test::run_glassbox({"view", "--script", "a.script"}, {.folder = folder.path});
    };
    CHECK(run("open edges\nsize 500x400\nfail\nkey .\nzoom 60\nset scale percentile\nset legend off\nscreenshot a.png\n"
              "overlay margin\nset scale symlog\nset legend on\nbrush -4 2\nscreenshot b.png\n")
              .status == 0);
    CHECK(std::filesystem::exists(folder / "b.png"));
    const auto says = [&](const std::string& text, const std::string& error) {
        const test::Ran ran = run(text);
        CAPTURE(ran.err);
        CHECK(ran.status == 1);
        CHECK(ran.err.find(error) != std::string::npos);
    };
    says("open sphere\nfail\n", "a.script:2:1: error: fail: the scene does not say with what it fails");
    says("brush 0 1\n", "a.script:1:1: error: brush: nothing is laid over; put 'overlay NAME' before");
    says("brush 2 1\n", "a.script:1:1: error: brush: LOW must not be above HIGH, and 2 is above 1");
    says("set scale lgo\n", "a.script:1:1: error: scale: 'lgo' is not known; did you mean 'log'?");
}
