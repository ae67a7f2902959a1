// `glassbox measure`: the numbers behind a picture, in all its formats.
#include <doctest.h>

#include "cli/program.hpp"
#include "cli/tiny_scene.hpp"

using namespace glassbox::test;

namespace {

struct Workplace : Folder {
    Workplace() { write(*this / "s.toml", tiny_scene); }

    Ran measure(const std::string& what, const std::string& out, const Arguments& more = {}) const {
        Arguments arguments{"measure", "s.toml", "--what", what, "-o", out};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return run_glassbox(arguments, {.folder = path});
    }
};

}  // namespace

TEST_CASE("CSV: a header, then a row a pixel from the top left, empty where there is no value") {
    const Workplace folder;
    const Ran ran = folder.measure("hits,depth,normal", "m.csv");
    CHECK(ran.status == 0);
    CHECK(ran.out == "");
    CHECK(ran.err == "");
    // The middle ray meets the ball 499 from its start, the four tangent ones at 500, level with the ball's centre:
    // there the normal points away from the centre.
    CHECK(content(folder / "m.csv") ==
          "x,y,hits,depth,normal.x,normal.y,normal.z\n"
          "0,0,0,,,,\n"
          "1,0,1,500,0,0,1\n"
          "2,0,0,,,,\n"
          "3,0,0,,,,\n"
          "0,1,1,500,0,-1,0\n"
          "1,1,1,499,1,0,0\n"
          "2,1,1,500,0,1,0\n"
          "3,1,0,,,,\n"
          "0,2,0,,,,\n"
          "1,2,1,500,0,0,-1\n"
          "2,2,0,,,,\n"
          "3,2,0,,,,\n");
}

TEST_CASE("pictures with legends, and EXR") {
    const Workplace folder;
    for (const auto& [name, start] : {std::pair<const char*, std::string>{"m.png", "\x89PNG\r\n\x1a\n"},
                                      {"m.ppm", "P6\n"},
                                      {"m.exr", "\x76\x2f\x31\x01"},
                                      {"M.EXR", "\x76\x2f\x31\x01"}}) {
        const Ran ran = folder.measure("depth,n.l,hits", name);
        CHECK(ran.status == 0);
        CHECK(ran.err == "");
        CHECK(content(folder / name).starts_with(start));
    }
    const std::string exr = content(folder / "m.exr");  // one layer for each, by name
    for (const char* layer : {"depth", "n.l", "hits"}) CHECK(exr.find(std::string(layer) + '\0') != std::string::npos);
    CHECK(folder.entries() == 5);
}

TEST_CASE("every measurement can be asked for, alone and with all others") {
    const Workplace folder;
    const std::string names[] = {"tests", "hits",    "depth",   "normal",   "n.l",          "n.h",
                                 "n.r",   "ambient", "diffuse", "specular", "discriminant", "side"};
    std::string all;
    for (const std::string& name : names) {
        CHECK(folder.measure(name, "m.csv").status == 0);
        const std::string header = name == "normal" ? "x,y,normal.x,normal.y,normal.z\n" : "x,y," + name + "\n";
        CHECK(content(folder / "m.csv").starts_with(header));
        if (!all.empty()) all += ',';
        all += name;
    }
    CHECK(folder.measure(all, "m.csv").status == 0);
    CHECK(folder.measure(all, "m.png").status == 0);
}

TEST_CASE("what has no value anywhere is noted in one line, with the reason, and written nonetheless") {
    const Workplace folder;
    const auto noted = [&](const std::string& what, const Arguments& more) {
        const Ran ran = folder.measure(what, "m.csv", more);
        CHECK(ran.status == 0);
        return ran.err;
    };
    const std::string none = "glassbox measure: note: no value at any pixel: ";
    CHECK(noted("depth,n.l,n.h", {"--shading", "phong"}) == none + "n.h (phong has no half vector)\n");
    CHECK(noted("side,depth", {"--triangle", "moeller-trumbore"}) ==
          none + "side (moeller-trumbore has no side products)\n");
    CHECK(noted("side", {}) == none + "side (no triangle was tested)\n");
    CHECK(noted("depth,hits", {"--size", "1x1", "--stage", "1"}) == none + "depth (from stage 2)\n");
    CHECK(content(folder / "m.csv") == "x,y,depth,hits\n0,0,,0\n");
    CHECK(noted("depth,side,n.l", {"--stage", "1"}) ==
          none + "depth (from stage 2), side (from stage 3), n.l (from stage 4)\n");
    CHECK(folder.measure("depth,normal", "m.png", {"--stage", "1"}).status == 0);
    CHECK(noted("depth", {"--stage", "2", "--turn", "z:1"}) ==
          "glassbox measure: note: not used: --turn (from stage 5)\n");
    write(folder / "empty.toml", "");
    CHECK(run_glassbox({"measure", "empty.toml", "--what", "hits,depth", "-o", "m.csv"}, {.folder = folder.path}).err ==
          none + "depth (no ray meets a surface)\n");
}

TEST_CASE("--scale: another spacing of the colours makes another picture; a wrong one is refused") {
    const Workplace folder;
    for (const char* scale : {"linear", "log", "symlog", "percentile"})
        CHECK(folder.measure("depth,verdict,normal", std::string(scale) + ".png", {"--scale", scale}).status == 0);
    CHECK(content(folder / "linear.png") != content(folder / "percentile.png"));
    const Ran wrong = folder.measure("depth", "m.png", {"--scale", "logarithmic"});
    CHECK(wrong.status == 2);
    CHECK(wrong.err.find("--scale: 'logarithmic' is not known; ") != std::string::npos);
}

TEST_CASE("--minus: the same by other settings is subtracted; what has no difference is refused") {
    const Workplace folder;
    // The paper's rule takes the four tangent rays for misses: one hit less, and no depth. By both the middle ray meets
    // the ball 499 from its start.
    CHECK(folder.measure("hits,depth", "m.csv", {"--sphere", "levental-2014", "--minus", "sphere:stable"}).err == "");
    CHECK(content(folder / "m.csv") ==
          "x,y,hits-minus-sphere:stable,depth-minus-sphere:stable\n"
          "0,0,0,\n"
          "1,0,-1,\n"
          "2,0,0,\n"
          "3,0,0,\n"
          "0,1,-1,\n"
          "1,1,0,0\n"
          "2,1,-1,\n"
          "3,1,0,\n"
          "0,2,0,\n"
          "1,2,-1,\n"
          "2,2,0,\n"
          "3,2,0,\n");
    for (const char* name : {"m.png", "m.ppm", "m.exr"})
        CHECK(folder.measure("depth,normal", name, {"--scalar", "float", "--minus", "scalar:exact"}).status == 0);
    const auto refused = [&](const std::string& what, const Arguments& more, const std::string& words) {
        const Ran ran = folder.measure(what, "none.csv", more);
        CAPTURE(ran.err);
        CHECK(ran.status == 2);
        CHECK(ran.err.find(words) != std::string::npos);
        CHECK_FALSE(std::filesystem::exists(folder / "none.csv"));
    };
    refused("depth,verdict", {"--minus", "scalar:exact"}, "--minus: verdict is told in words");
    refused("depth", {"--minus", "exact"}, "--minus: 'exact' must be NAME:VALUE");
    refused("depth", {"--minus", "scalar:exact", "--scale", "log"}, "--scale: a difference has both signs");
    CHECK(folder.measure("depth", "m.csv", {"--minus", "scalar:certified"}).err ==
          "glassbox measure: note: --minus changes nothing: every difference is 0\n");
}
