// Command lines: a bad one is rejected with one line that says what is wrong, with exit status 2, and nothing is
// written.
#include <doctest.h>

#include <cstdlib>

#include "cli/program.hpp"
#include "cli/tiny_scene.hpp"

using namespace glassbox::test;

namespace {

struct Bad {
    Arguments arguments;
    std::vector<std::string> parts;
};

void check_all(const std::vector<Bad>& lines) {
    const Folder folder;
    write(folder / "s.toml", tiny_scene);
    for (const auto& [arguments, parts] : lines) check_refused(folder, arguments, 2, parts);
}

/// `render s.toml` with more arguments.
Arguments render(const Arguments& more) {
    Arguments all{"render", "s.toml"};
    all.insert(all.end(), more.begin(), more.end());
    return all;
}

Arguments measure(const std::string& what) { return {"measure", "s.toml", "--what", what, "-o", "m.csv"}; }

}  // namespace

TEST_CASE("a command that is missing or unknown: the error says which there are") {
    check_all({
        {{}, {"glassbox: error: a command is missing", "'render', 'measure', 'shoot'", "see 'glassbox --help'"}},
        {{"rendr"}, {"glassbox: error: 'rendr' is no command; did you mean 'render'?"}},
        {{"paint", "s.toml"}, {"glassbox: error: 'paint' is no command", "'render', 'measure'"}},
        {{"--vesion"}, {"glassbox: error: --vesion is not an option; did you mean '--version'?"}},
        {{"--size", "4x3", "render", "s.toml"}, {"--size must follow the command", "'glassbox render --size'"}},
    });
}

TEST_CASE("an unknown option: the error names the nearest") {
    check_all({
        {render({"--thread", "3"}), {"glassbox render: error: --thread is not an option; did you mean '--threads'?"}},
        {{"render", "--thread=3"}, {"--thread is not an option; did you mean '--threads'?"}},
        {{"shoot", "s.toml", "--ray", "r.csv"}, {"glassbox shoot: error: --ray", "did you mean '--rays'?"}},
        {render({"--frobnicate"}), {"--frobnicate is not an option; see 'glassbox render --help'"}},
        {render({"-x"}), {"-x is not an option; see"}},
        {render({"--size 4x3"}), {"'--size 4x3' is one word; write it as two"}},
        {{"doctor", "--size", "4x3"}, {"glassbox doctor: error: --size is not an option"}},
    });
}

TEST_CASE("a word too many, too few, or twice") {
    check_all({
        {render({"t.toml"}), {"glassbox render: error: 't.toml' is one word too many"}},
        {{"doctor", "s.toml"}, {"glassbox doctor: error: 's.toml' is one word too many"}},
        {{"render"}, {"glassbox render: error: SCENE is missing: a scene file"}},
        {{"measure", "s.toml", "-o", "m.csv"}, {"glassbox measure: error: --what is missing"}},
        {{"measure", "s.toml", "--what", "depth"}, {"glassbox measure: error: --out is missing"}},
        {{"shoot", "s.toml"}, {"glassbox shoot: error: --rays is missing", "ox,oy,oz,dx,dy,dz"}},
        {render({"--size"}), {"--size: a value is missing; write --size WxH"}},
        {render({"--size="}), {"--size: a value is missing; write --size WxH"}},
        {render({"--size", "--threads", "2"}), {"--size: a value is missing before --threads"}},
        {render({"-o", "--size", "2x2"}), {"--out: a value is missing before --size"}},
        {render({"--threads", "1", "--threads", "2"}), {"--threads: given 2 times; give it once"}},
        {render({"--accumulated", "--threads", "1", "--threads", "2"}), {"--threads: given 2 times; give it once"}},
        {render({"-o", "a.png", "--out", "b.png"}), {"--out: given 2 times; give it once"}},
        {render({"-o", ""}), {"--out: '' must be the name of a file"}},
        {{"shoot", "s.toml", "--rays", ""}, {"--rays: '' must be the name of a file"}},
    });
}

TEST_CASE("a size is two whole numbers, not 0, not too large") {
    for (const char* shape : {"5x", "x5", "x", "", "5", "1e3x10", "5.5x5", "5x5x5", "5*5", " 5x5", "5x 5", "ax5"})
        check_all({{render({"--size", shape}), {"--size: ", "WIDTHxHEIGHT"}}});
}

TEST_CASE("values of options") {
    check_all({
        {render({"--size", "0x5"}), {"--size: 0x5 must be from 1 to 32768 pixels a side"}},
        {render({"--size", "5x0"}), {"--size: 5x0 must be"}},
        {render({"--size", "-1x5"}), {"--size: -1x5 must be"}},
        {render({"--size", "1000000000x1"}), {"--size: 1000000000x1 must be", "32768"}},
        {render({"--size", "32768x32768"}), {"--size: 32768x32768 must be", "at most 268435456 in all"}},
        {render({"--stage", "0"}), {"--stage: '0' must be a whole number from 1 to 5"}},
        {render({"--stage", "6"}), {"--stage: '6' must be a whole number from 1 to 5"}},
        {render({"--stage", "2.5"}), {"--stage: '2.5' must be"}},
        {render({"--threads", "0"}), {"--threads: '0' must be a whole number from 1 to"}},
        {render({"--threads", "99999999999999999999"}), {"--threads: '99999999999999999999' must be"}},
        {render({"--ambient", "-1"}), {"--ambient: '-1' must be a number, 0 or more"}},
        {render({"--diffuse", "nan"}), {"--diffuse: 'nan' must be a number, 0 or more"}},
        {render({"--specular", "inf"}), {"--specular: 'inf' must be"}},
        {render({"--exponent", "1e999"}), {"--exponent: '1e999' must be"}},
        {render({"--ambient", "much"}), {"--ambient: 'much' must be"}},
        {render({"--shading", "fong"}), {"--shading: 'fong' is not known; did you mean 'phong'?"}},
        {render({"--scalar", "duoble"}), {"--scalar: 'duoble' is not known; did you mean 'double'?"}},
        {render({"--triangle", "plucker"}), {"--triangle: 'plucker' is not known; did you mean 'pluecker'?"}},
        {render({"--triangle", "tolerance:"}), {"--triangle tolerance: '' must be a number, 0 or more"}},
        {render({"--triangle", "tolerance:-1"}), {"--triangle tolerance: '-1' must be a number, 0 or more"}},
        {render({"--intensity", "-1"}), {"--intensity: '-1' must be a number, 0 or more"}},
        {render({"--light", "1,2"}), {"--light: '1,2' must be X,Y,Z, three numbers"}},
        {render({"--light", "1,2,x"}), {"--light: '1,2,x' must be X,Y,Z"}},
        {render({"--light", "1,2,inf"}), {"--light: '1,2,inf' must be X,Y,Z"}},
        {render({"--light", "0,0,0"}), {"--light: '0,0,0' is 0 in x, y and z; it must have a direction"}},
        {render({"--light", "1e200,0,0"}), {"--light: '1e200,0,0' has the size 1e+200", "from 1e-150 to 1e150"}},
        {{"bench", "--cliffs", "--only", "nonesuch"}, {"--only: no case's name contains 'nonesuch'"}},
        {{"bench", "--against", "embree", "--check", "0"}, {"--check: '0' must be a whole number from 1"}},
        {{"view", "s.toml", "--mine=8"}, {"glassbox view: error: --mine: '8' must be a lesson, 1 to 7, or all"}},
        {{"view", "s.toml", "--mine=alll"}, {"--mine: 'alll' must be a lesson, 1 to 7, or all"}},
        {render({"--sphere", "round"}), {"--sphere: 'round' is not known", "'stable', 'textbook'"}},
    });
}

TEST_CASE("turns are axes and degrees between commas") {
    for (const char* turns : {"", "z", "z:", "10", "w:10", "Z:10", "z=10", "z:ten", "z:nan", "z:1e999", "z:10,,y:5",
                              "z:10,", ",z:10", "z:10, y:5", "z:10 y:5", "z:+-5", "zz:5"})
        check_all({{render({"--turn", turns}), {"--turn: '", "z:10,y:-20"}}});
}

TEST_CASE("measurements are names between commas, each once") {
    check_all({
        {measure("depht"), {"--what: 'depht' is not known; did you mean 'depth'?"}},
        {measure(""), {"--what: '' is not known; it must be one of 'tests', 'hits', 'depth'"}},
        {measure("depth,,"), {"--what: '' is not known"}},
        {measure("depth,hits,depth"), {"--what: 'depth' is there twice; name it once"}},
        {measure("[depth]"), {"--what: '[depth]' is not known; did you mean 'depth'?"}},
    });
}

TEST_CASE("control characters do not break the line") {
    check_all({{render({"--size", "a\nb\x1b[31m"}), {"'a?b?[31m'"}}});
    check_all({{render({"--size", "a\u009b31m\u202eb\xe9"}), {"'a?31m?b?'"}}});  // C1, right-to-left, not UTF-8
}

TEST_CASE("help and version: for every command, on stdout, status 0") {
    const Folder folder;
    const Ran version = run_glassbox({"--version"}, {.folder = folder.path});
    CHECK(version.status == 0);
    CHECK(version.out.starts_with("glassbox "));
    const Ran help = run_glassbox({"--help"}, {.folder = folder.path});
    CHECK(help.status == 0);
    for (const char* command : {"render", "measure", "shoot", "bench", "doctor"}) {
        CHECK(help.out.find(command) != std::string::npos);
        const Ran page = run_glassbox({command, "--help"}, {.folder = folder.path});
        CHECK(page.status == 0);
        CHECK(page.err == "");
        CHECK(page.out.find("Usage: glassbox " + std::string(command)) != std::string::npos);
    }
    for (const char* command : {"render", "measure", "shoot"}) {
        const Ran page = run_glassbox({command, "-h"}, {.folder = folder.path});
        for (const char* option : {"--size", "--stage", "--turn", "--accumulated", "--light", "--intensity",
                                   "--ambient", "--diffuse", "--specular", "--exponent", "--shading", "--scalar",
                                   "--triangle", "--sphere", "--threads", "Example: glassbox"})
            CHECK_MESSAGE(page.out.find(option) != std::string::npos, option);
    }
}

TEST_CASE("doctor finds this build good") {
    const Folder folder;
    const Ran ran = run_glassbox({"doctor"}, {.folder = folder.path});
    CHECK(ran.status == 0);
    CHECK(ran.err == "");
    CHECK(ran.out.find("All is well.") != std::string::npos);
    CHECK(ran.out.find("BAD") == std::string::npos);
}

#if defined FLUSHES_SUBNORMALS && !defined GLASSBOX_SANITIZED
TEST_CASE("doctor notices a library that flushes subnormal numbers, and says which bounds do not hold") {
    const Folder folder;
    ::setenv("LD_PRELOAD", FLUSHES_SUBNORMALS, 1);
    const Ran ran = run_glassbox({"doctor"}, {.folder = folder.path});
    ::unsetenv("LD_PRELOAD");
    CHECK(ran.status == 1);
    CHECK(ran.out.find("BAD   results below the normal numbers are kept, not flushed to 0: not in float, double;") !=
          std::string::npos);
    CHECK(ran.out.find("BAD   numbers below the normal ones are taken as they are, not as 0: not in float, double;") !=
          std::string::npos);
    CHECK(ran.out.find("3 not as it should be: see BAD above.") != std::string::npos);  // and floats made of doubles
}
#endif
