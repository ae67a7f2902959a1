// The story as a student reads it: what it must contain, and that it fits a terminal.
#include "explain/text.hpp"

#include <doctest.h>

#include <algorithm>
#include <sstream>

#include "explain/explain.hpp"
#include "scene/scene_file.hpp"

using namespace glassbox;

namespace {

std::string text(const char* scene, int x, int y, const Options& options = {}) {
    Story story = explain(read_scene(std::string(SCENES "/") + scene), options, x, y);
    story.command = "glassbox explain it";
    return to_text(story);
}

void check_has(const std::string& text, const std::vector<std::string>& parts) {
    for (const std::string& part : parts) CHECK_MESSAGE(text.find(part) != std::string::npos, part);
}

}  // namespace

// n·l = 4/√18 = 0.942809041… = cos 19.47°, n·h = 1001/√(1001² + 2·250²) = 0.942913658…: all their digits are printed.
TEST_CASE("a sphere's pixel") {
    check_has(text("levental-2014.toml", 350, 149), {"✓ right, proven, ",
                                                     " digits to spare: surface 0 is shown, and nearest\nPixel (350, "
                                                     "149) of 500 × 500, column 350 and row 350 from the bottom left",
                                                     "(72, 255, 41), #48ff29",
                                                     "sphere of colour (0, 255, 0), surface 0, at t = 350",
                                                     "glassbox explain it",
                                                     "P = (500, 350, 350)",
                                                     "0x1.f4p+8",
                                                     "met, nearest: t = 350",
                                                     "missed: Δ < 0",
                                                     "side products of both signs",
                                                     "textbook",
                                                     "stable",
                                                     "Δ  = 2500",
                                                     "t₁ = 450",
                                                     "normal = (1, 0, 0)",
                                                     "n·l = 0.94280904",
                                                     "n·h = 0.94291365",
                                                     "shown     sphere",
                                                     "search    6 tested, 1 met",
                                                     "margin    ",
                                                     "19.5°",
                                                     "    0 ✓ sphere",
                                                     "✓ truly > 0",
                                                     "(51, 20, 20)",
                                                     "(0, 240, 0)",
                                                     "the most was lost by",
                                                     "bits of its own, "});
}

TEST_CASE("a sphere that the paper's program misses") {
    Options options;
    options.sphere_rule = Levental2014{};
    check_has(text("levental-2014.toml", 400, 149, options),
              {"✗ wrong miss, proven in exact arithmetic: nothing is shown, and surface 0 is there;\n  so says the "
               "rule levental-2014",
               "    0 ✗ sphere", "wrong: truly met, nearest", "spheres: levental-2014",
               "missed: Δ = 0, a touch, no hit by levental-2014", "nothing is met"});
    check_has(text("inside.toml", 20, 20, options), {"missed: its nearer root lies behind, t = −"});
}

TEST_CASE("a triangle's pixel, seen through a corner") {
    check_has(text("levental-2014.toml", 350, 399),
              {"met, as near as surface 4, which is listed later and so is seen: t = 300", "met, nearest: t = 300",
               "all side products are 0", "a = 2500", "b = 0 exact", "the paper's rule says hit",
               "the paper's rule says miss", "weights  A: 1  B: 0  C: 0"});
}

TEST_CASE("whose arithmetic it is") {
    Options options;
    options.scalar = Scalar::float_;
    const std::string in_float = text("levental-2014.toml", 333, 138, options);
    check_has(in_float, {"computed  float, steps in float"});
    CHECK(in_float.find("exact arithmetic") == std::string::npos);
    check_has(text("levental-2014.toml", 333, 138), {"computed  certified, steps in double"});
    options.scalar = Scalar::long_double;
    check_has(text("levental-2014.toml", 333, 138, options), {"computed  long-double, steps in long-double"});
}

TEST_CASE("background, border, first stage") {
    check_has(text("levental-2014.toml", 7, 7), {"nothing is met: the background", "6 in all, 0 met"});
    check_has(text("levental-2014.toml", 0, 7), {"the border, painted over what the ray brings: (0, 0, 0)"});
    Options options;
    options.stage = 1;
    check_has(text("levental-2014.toml", 7, 7, options), {"stage 1 knows no surfaces", "as a colour (0, 102, 102)"});
}

TEST_CASE("many surfaces: the nearest misses, and how many more there are") {
    check_has(text("room.toml", 100, 200), {"1255 in all, 2 met", "and 1235 more"});
}

TEST_CASE("no line is wider than 100 columns") {
    const auto check_narrow = [](const std::string& page) {
        std::istringstream lines(page);
        for (std::string line; std::getline(lines, line);) {
            // Count only bytes that begin a character.
            const auto columns = std::count_if(line.begin(), line.end(),
                                               [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; });
            CHECK_MESSAGE(columns <= 100, line);
        }
    };
    for (const char* scene : {"levental-2014.toml", "room.toml", "fan.toml", "spheres-far.toml"})
        for (const int x : {0, 100, 201, 350})
            for (const int y : {0, 33, 149, 200}) check_narrow(text(scene, x, y));
    Options options;
    options.sphere_rule = Levental2014{};
    check_narrow(text("levental-2014.toml", 400, 149, options));
    check_narrow(text("inside.toml", 20, 20, options));
}
