#include <doctest.h>

#include <filesystem>
#include <string>

#include "cli/program.hpp"
#include "cli/tiny_scene.hpp"

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

TEST_CASE("save: the bytes that render and measure write") {
    const test::Folder folder;
    std::filesystem::copy_file(scenes / "triangle.toml", folder / "s.toml");
    test::write(folder / "a.script",
                "set scalar float\nturn z:10\noverlay depth\nbeside other\nset other-scalar double\n"
                "save p.ppm\nsave p.png\nsave d.csv\nsave d.exr\nsave d.png overlay\nsave b.png beside\n");
    const test::Ran ran = test::run_glassbox({"view", "s.toml", "--script", "a.script"}, {.folder = folder.path});
    CAPTURE(ran.err);
    REQUIRE(ran.status == 0);
    const auto same = [&](const test::Arguments& arguments, const std::string& saved) {
        test::Arguments with_file = arguments;
        const std::string made = "made" + std::filesystem::path(saved).extension().string();
        with_file.insert(with_file.end(), {"-o", made});
        CHECK(test::run_glassbox(with_file, {.folder = folder.path}).status == 0);
        CHECK_MESSAGE(test::content(folder / made) == test::content(folder / saved), saved);
    };
    for (const char* file : {"p.ppm", "p.png"}) same({"render", "s.toml", "--scalar", "float", "--turn", "z:10"}, file);
    for (const char* file : {"d.csv", "d.exr", "d.png"})
        same({"measure", "s.toml", "--scalar", "float", "--turn", "z:10", "--what", "depth"}, file);
    same({"render", "s.toml", "--scalar", "double", "--turn", "z:10"}, "b.png");
}

TEST_CASE("save: what there is not, and files that cannot be") {
    const test::Folder folder;
    const std::string triangle = (scenes / "triangle.toml").string();
    const auto refused = [&](const std::string& line, const std::vector<std::string>& parts) {
        test::write(folder / "a.script", line + "\n");
        test::check_refused(folder, {"view", triangle, "--script", "a.script"}, 1, parts);
    };
    refused("save d.csv", {"a.script:1:1: error: ", "no overlay", "page Overlay"});
    refused("save b.png beside", {"nothing stands beside the picture"});
    refused("save p.gif", {"unknown extension .gif; use .png or .ppm"});
    refused("save none/p.png", {"create the folder none/ first"});
    refused("save p.png pictures", {"'pictures' is not known; did you mean 'picture'?"});
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

TEST_CASE("a script steps as a debugger does, and is told what cannot be") {
    const test::Folder folder;
    const std::string begin = "open '" + (scenes / "levental-2014.toml").string() + "'\nsize 500x400\npin 350,149\n";
    test::write(
        folder / "steps.script",
        begin +
            "step no\nstep operand\nstep jump-back\nstep into\nstep over\nstep out\nfeeding on\nfeeding off\n"
            "set step-pane losses\nnudge P.y:-1\nnudge radius:100\nnudge undo\nnudge reset\nscreenshot a.png\n");
    const test::Ran ran = test::run_glassbox({"view", "--script", "steps.script"}, {.folder = folder.path});
    CAPTURE(ran.err);
    CHECK(ran.status == 0);
    const auto refused = [&](const std::string& line, const std::vector<std::string>& words) {
        test::write(folder / "wrong.script", begin + "step first\n" + line + "\n");
        test::check_refused(folder, {"view", "--script", "wrong.script"}, 1, words);
    };
    refused("nudge P.q:1", {"wrong.script:5:1: error: ", "'P.q' is not known", "did you mean 'P."});
    refused("nudge P.y", {"wrong.script:5:1: error: ", "NAME:BY, undo or reset"});
    refused("nudge P.y:200000", {"wrong.script:5:1: error: ", "100000"});
    refused("feeding on", {"wrong.script:5:1: error: ", "no operation"});
    refused("pin none\nfeeding on", {"wrong.script:6:1: error: ", "no pixel is pinned"});
    refused("pin 5,5\nnudge P.y:1", {"wrong.script:6:1: error: ", "no surface to test"});
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

TEST_CASE("an overlay minus the same by other settings: what is saved is what measure --minus writes") {
    const test::Folder folder;
    test::write(folder / "s.toml", test::tiny_scene);
    const auto run = [&](const std::string& text) {
        test::write(folder / "a.script", text);
        return test::run_glassbox({"view", "--script", "a.script"}, {.folder = folder.path});
    };
    const std::string begin = "open s.toml\nsize 700x600\nset sphere levental-2014\npage overlay\noverlay hits\n";
    // The worst pixel is a tangent one, where the paper's rule has a hit less: the first in reading order is (1, 0).
    const test::Ran ran =
        run(begin +
            "set overlay-minus sphere:stable\nkey .\nscreenshot a.png\nsave v.csv\nsave v.png overlay\n"
            "overlay verdict\nscreenshot b.png\nset overlay-minus nothing\nscreenshot c.png\n");
    CAPTURE(ran.err);
    REQUIRE(ran.status == 0);
    for (const char* name : {"m.csv", "m.png"})
        test::run_glassbox({"measure", "s.toml", "--what", "hits", "--sphere", "levental-2014", "--minus",
                            "sphere:stable", "-o", name},
                           {.folder = folder.path});
    CHECK(test::content(folder / "v.csv") == test::content(folder / "m.csv"));
    CHECK(test::content(folder / "v.csv").starts_with("x,y,hits-minus-sphere:stable\n0,0,0\n1,0,-1\n"));
    CHECK(test::content(folder / "v.png") == test::content(folder / "m.png"));
    const test::Ran wrong = run("set overlay-minus exact\n");
    CHECK(wrong.status == 1);
    CHECK(wrong.err.find("overlay-minus: 'exact' must be NAME:VALUE") != std::string::npos);

    const auto view = [&](test::Arguments more) {
        more.insert(more.begin(), {"view", "s.toml", "--screenshot", "d.png"});
        return test::run_glassbox(more, {.folder = folder.path});
    };
    CHECK(view({"--overlay", "depth", "--minus", "scalar:float"}).status == 0);
    CHECK(view({"--overlay", "verdict", "--minus", "scalar:float"}).err.find("told in words") != std::string::npos);
    CHECK(view({"--minus", "scalar:float"}).err.find("--minus: needs a measurement") != std::string::npos);
}
