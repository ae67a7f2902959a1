// `glassbox compare`: what rounding may do is told from mistakes, and both from what is right.
#include <doctest.h>
#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "cli/program.hpp"
#include "output/png.hpp"
#include "output/ppm.hpp"
#include "output/read_picture.hpp"

using namespace glassbox;
using namespace glassbox::test;
using nlohmann::json;

namespace {

constexpr const char* rays_header = "ox,oy,oz,dx,dy,dz\n";

/// A unit ball about the origin (surface 0); two equal triangles at z = −5 (1 and 2), and one at z = −7 (3).
struct Workplace : Folder {
    Workplace() {
        write(*this / "s.toml",
              "[[sphere]]\ncenter = [0, 0, 0]\nradius = 1\n"
              "[[triangle]]\nvertices = [[0, 0, -5], [4, 0, -5], [0, 4, -5]]\n"
              "[[triangle]]\nvertices = [[0, 0, -5], [4, 0, -5], [0, 4, -5]]\n"
              "[[triangle]]\nvertices = [[0, 0, -7], [4, 0, -7], [0, 4, -7]]\n");
    }

    Ran compare(const Arguments& more) const {
        Arguments arguments{"compare", "s.toml"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return run_glassbox(arguments, {.folder = path});
    }

    /// The comparison of one ray with what is said of it.
    json compare_ray(const std::string& ray, const std::string& claim, const Arguments& more = {}) const {
        write(*this / "r.csv", rays_header + ray + "\n");
        write(*this / "h.csv", "verdict,surface,t\n" + claim + "\n");
        Arguments arguments{"--rays", "r.csv", "--hits", "h.csv", "--json"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        const Ran ran = compare(arguments);
        CAPTURE(ran.err);
        REQUIRE(ran.out.starts_with("{"));
        json told = json::parse(ran.out);
        CHECK(ran.status == (told["mistake"] == 0 && told["unknown"] == 0 ? 0 : 1));
        return told;
    }

    /// In what it is wrong and why: "t mistake"; "" where it is not.
    std::string judged(const std::string& ray, const std::string& claim, const Arguments& more = {}) const {
        const json told = compare_ray(ray, claim, more);
        if (told["worst"].empty()) return told["ties"] == 1 ? "tie" : "";
        const json& one = told["worst"][0];
        return one["wrong"].get<std::string>() + ' ' + one["cause"].get<std::string>();
    }
};

std::string written(double number) { return fmt::format("{}", number); }

void write_ppm(const std::filesystem::path& path, const Image& image) {
    const std::vector<std::byte> bytes = ppm(image);
    write(path, {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
}

}  // namespace

TEST_CASE("what is true does not differ") {
    const Workplace folder;
    CHECK(folder.judged("0.25,0.5,10,0,0,-1", "hit,0,9.17084380241115") == "");  // 10 − √(1 − 5/16), rounded
    CHECK(folder.judged("1.5,1,10,0,0,-1", "hit,2,15") == "");                   // of equals the one listed last
    CHECK(folder.judged("9,9,9,0,0,-1", "miss,,") == "");
    CHECK(folder.judged("0,0,9,0,0,0", "invalid,,") == "");
    CHECK(folder.judged("1.5,1,10,0,0,-1", "hit,,15") == "");
    CHECK(folder.judged("1.5,1,10,0,0,-1", "hit,2,") == "");
    CHECK(folder.judged("1.5,1,10,0,0,-1", "hit,,") == "");
}

TEST_CASE("another surface at exactly the same t is a tie, and no mistake") {
    const Workplace folder;
    CHECK(folder.judged("1.5,1,10,0,0,-1", "hit,1,15") == "tie");
    CHECK(folder.judged("1.5,1,10,0,0,-1", "hit,1,15.5") == "t mistake");
}

TEST_CASE("mistakes: wrong hit, miss, surface, t, validity") {
    const Workplace folder;
    CHECK(folder.judged("9,9,9,0,0,-1", "hit,3,16") == "hit mistake");
    CHECK(folder.judged("9,9,9,0,0,-1", "hit,,16") == "hit mistake");
    CHECK(folder.judged("1.5,1,10,0,0,-1", "miss,,") == "miss mistake");
    CHECK(folder.judged("1.5,1,10,0,0,-1", "hit,3,17") == "surface mistake");  // it lies behind
    CHECK(folder.judged("1.5,1,10,0,0,-1", "hit,0,9") == "surface mistake");   // the ray passes it
    CHECK(folder.judged("0,0,9,0,0,0", "miss,,") == "validity mistake");
    CHECK(folder.judged("0,0,9,0,0,-1", "invalid,,") == "validity mistake");
    CHECK(folder.judged("0,0,9,0,0,-1", "hit,0,nan") == "t mistake");
}

TEST_CASE("a t may be off by a few units in its last place, and no more") {
    const Workplace folder;
    const std::string ray = "0.3,0.5,10,0.01,0,-1";
    const double v = 0.3 * 0.01 - 10, a = 0.01 * 0.01 + 1, k = 0.3 * 0.3 + 0.5 * 0.5 + 100 - 1;
    const double t = (-v - std::sqrt(v * v - a * k)) / a;  // within some 1e-14 of the true one
    CHECK(folder.judged(ray, "hit,0," + written(t + 0x1p-46)) == "t rounding");
    CHECK(folder.judged(ray, "hit,0," + written(t + 1e-7)) == "t mistake");
    CHECK(folder.judged(ray, "hit,0," + written(t + 1e-7), {"--precision", "float"}) == "");  // the same float
    CHECK(folder.judged(ray, "hit,0," + written(t + 3e-6), {"--precision", "float"}) == "t rounding");
    CHECK(folder.judged(ray, "hit,0," + written(t + 1e-2), {"--precision", "float"}) == "t mistake");
    CHECK(folder.judged(ray, fmt::format("hit,0,{:.6g}", t)) == "");  // as streams write it by default
}

TEST_CASE("a tangent in whole numbers is no matter of rounding; one that is not, is") {
    const Workplace folder;
    // (−1)² = 1: Δ is 0, and every program finds it so. The triangles lie elsewhere.
    CHECK(folder.judged("-1,0,5,0,0,-1", "hit,0,5") == "");
    CHECK(folder.judged("-1,0,5,0,0,-1", "miss,,") == "miss mistake");
    // 0.6 as a double is 2.2e-17 too small, 0.8 4.4e-17 too large: their squares add up to 1 − 2·0.6·2.2e-17 +
    // 2·0.8·4.4e-17, more than 1 by less than half a unit of its last place.
    CHECK(folder.judged("-0.6,-0.8,5,0,0,-1", "miss,,") == "");
    CHECK(folder.judged("-0.6,-0.8,5,0,0,-1", "hit,0,5") == "hit rounding");
    // A hair beyond: for double that is far.
    CHECK(folder.judged("-1.00000001,0,5,0,0,-1", "hit,0,5") == "hit mistake");
    CHECK(folder.judged("-1.00000001,0,5,0,0,-1", "hit,0,5", {"--precision", "float"}) == "hit rounding");
}

TEST_CASE("each call says how near it was: value, bound and how many times the one is the other") {
    const Workplace folder;
    // 9 off the axis: Δ = 1 − 2·81, in whole numbers and so exact; 9.1 is none.
    const json exact = folder.compare_ray("9,9,9,0,0,-1", "hit,0,9")["worst"][0]["calls"][0];
    CHECK(exact["what"] == "Δ");
    CHECK(exact["value"] == -161);
    CHECK(exact["error"] == 0);
    const json rounded = folder.compare_ray("9.1,9,9,0,0,-1", "hit,0,9")["worst"][0]["calls"][0];
    CHECK(rounded["value"].get<double>() == doctest::Approx(1 - 9.1 * 9.1 - 81));
    CHECK(rounded["error"].get<double>() > 0);
    CHECK(rounded["error"].get<double>() < 1e-12);
    CHECK(rounded["times"].get<double>() ==
          doctest::Approx(std::abs(rounded["value"].get<double>()) / rounded["error"].get<double>()));
    CHECK(rounded["may_differ"] == false);
}

TEST_CASE("a ray is shown again by the command that is told") {
    const Workplace folder;
    const json told = folder.compare_ray("1.5,1,10,0,0,-1", "miss,,", {"--stage", "3"});
    CHECK(told["first"]["command"] == "glassbox explain s.toml --stage 3 --ray 1.5,1,10,0,0,-1");
    const Ran ran = run_glassbox({"explain", "s.toml", "--ray", "1.5,1,10,0,0,-1", "--json"}, {.folder = folder.path});
    const json story = json::parse(ran.out);
    CHECK(story["surface"] == 2);
    CHECK(story["ray"]["P"] == json::array({1.5, 1.0, 10.0}));
    CHECK(story["hit"]["t"]["value"] == 15);
    check_refused(folder, {"explain", "s.toml"}, 2, {"--pixel is missing"});
    check_refused(folder, {"explain", "s.toml", "--ray", "1,2,3"}, 2, {"--ray: '1,2,3' must be OX,OY,OZ,DX,DY,DZ"});
    check_refused(folder, {"explain", "s.toml", "--ray", "1,2,3,0,0,0"}, 2, {"has the direction 0,0,0"});
    check_refused(folder, {"explain", "s.toml", "--ray", "1,2,3,0,0,1", "--pixel", "1,1"}, 2, {"--pixel", "--ray"});
}

TEST_CASE("what float gets wrong is float's rounding, and no double's") {
    const Workplace folder;
    // As scenes/mesh-far.toml sees it, every fourth pixel.
    std::string rays = rays_header;
    for (int y = 0; y < 120; y += 4)
        for (int x = 0; x < 180; x += 4)
            rays +=
                fmt::format("{},{},{},-1,-2,-2\n", 0.05 * x - 0.05 * y, -0.05 * x - 0.025 * y, 0.025 * x + 0.05 * y);
    write(folder / "r.csv", rays);
    const std::string scene = SCENES "/mesh-far.toml";
    for (const char* rule : {"pluecker", "moeller-trumbore"}) {
        run_glassbox({"shoot", scene, "--rays", "r.csv", "--scalar", "float", "--triangle", rule, "-o", "h.csv"},
                     {.folder = folder.path});
        const auto compared = [&](const char* precision) {
            return run_glassbox(
                {"compare", scene, "--rays", "r.csv", "--hits", "h.csv", "--precision", precision, "--json"},
                {.folder = folder.path});
        };
        const Ran in_float = compared("float"), in_double = compared("double");
        CHECK(in_float.status == 0);
        CHECK(json::parse(in_float.out)["mistake"] == 0);
        CHECK(json::parse(in_float.out)["rounding"] > 100);  // of 1350 rays most of those at three of six icosahedra
        CHECK(in_double.status == 1);
        CHECK(json::parse(in_double.out)["mistake"] > 100);
        CHECK(json::parse(in_double.out)["beyond_float"] == 0);
    }
}

namespace {

/// A red ball before black, above the middle of a picture of 40 x 30, and a triangle below.
struct Pictures : Folder {
    Pictures() {
        write(*this / "s.toml",
              "[image]\nwidth = 40\nheight = 30\n[view]\ncorner = [0, 0, 9]\nright = [1, 0, 0]\nup = [0, 1, 0]\n"
              "direction = [0, 0, -1]\n[light]\nposition = [1, 2, 3]\n"
              "[[sphere]]\ncenter = [12.3, 20.1, 0]\nradius = 6.2\ncolor = [200, 40, 10]\n"
              "[[triangle]]\nvertices = [[20.2, 3.3, 0], [35.1, 4.4, 0], [26.6, 16.2, 0]]\ncolor = [20, 90, 240]\n");
        run_glassbox({"render", "s.toml", "-o", "ours.png"}, {.folder = path});
    }

    Image ours() const { return read_picture(*this / "ours.png"); }

    json compare(const Image& theirs, const Arguments& more = {}) const {
        write_ppm(*this / "theirs.ppm", theirs);
        Arguments arguments{"compare", "s.toml", "theirs.ppm", "--json"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        const Ran ran = run_glassbox(arguments, {.folder = path});
        CAPTURE(ran.err);
        REQUIRE(ran.out.starts_with("{"));
        json told = json::parse(ran.out);
        CHECK(ran.status == (told["mistake"] == 0 && told["unknown"] == 0 ? 0 : 1));
        return told;
    }
};

/// Their picture is ours at `place(x, y)`.
template <class Place>
Image rearranged(const Image& ours, const Place& place) {
    Image theirs(ours.width, ours.height);
    for (int y = 0; y < ours.height; ++y)
        for (int x = 0; x < ours.width; ++x) theirs.at(x, y) = place(ours, x, y);
    return theirs;
}

}  // namespace

TEST_CASE("our own picture does not differ, as PNG and as PPM") {
    const Pictures folder;
    CHECK(folder.compare(folder.ours())["differ"] == 0);
    const Ran ran = run_glassbox({"compare", "s.toml", "ours.png"}, {.folder = folder.path});
    CHECK(ran.status == 0);
    CHECK(ran.out.starts_with("differ      0 of 1200 pixels\n"));
}

TEST_CASE("one pixel that is changed is found") {
    const Pictures folder;
    Image theirs = folder.ours();
    theirs.at(5, 5).green = 77;  // black before: nothing is met there
    const json told = folder.compare(theirs);
    CHECK(told["differ"] == 1);
    CHECK(told["greatest"] == 77);
    CHECK(told["mean"] == 77);
    CHECK(told["mistake"] == 1);
    CHECK(told["first"]["pixel"] == json::array({5, 5}));
    CHECK(told["first"]["shows"] == "nothing");
    CHECK(told["first"]["surface"] == nullptr);
    CHECK(told["first"]["command"] == "glassbox explain s.toml --pixel 5,5");
    CHECK(told["found"].empty());
}

TEST_CASE("a hole is told as such, with what is truly met, and how surely") {
    const Pictures folder;
    Image theirs = folder.ours();
    theirs.at(12, 9) = {};  // row 20 from below: through the ball, near its middle
    const json one = folder.compare(theirs)["first"];
    CHECK(one["shows"] == "background");
    CHECK(one["cause"] == "mistake");
    CHECK(one["surface"] == 0);
    // Δ = 6.2² − 0.3² − 0.1² and t = 9 − √Δ are both surely positive; what is less sure is told.
    const double delta = 6.2 * 6.2 - 0.3 * 0.3 - 0.1 * 0.1;
    const json& call = one["calls"][0];
    CHECK(call["value"].get<double>() == doctest::Approx(call["what"] == "Δ" ? delta : 9 - std::sqrt(delta)));
    CHECK(call["times"].get<double>() > 1e12);
}

TEST_CASE("a byte cut instead of rounded is rounding; two bytes are not") {
    const Pictures folder;
    const Image ours = folder.ours();
    const auto all_less = [&](int by) {
        return rearranged(ours, [&](const Image& image, int x, int y) {
            Rgb color = image.at(x, y);
            if (color.blue >= 2) color.blue = static_cast<std::uint8_t>(color.blue - by);
            return color;
        });
    };
    // From stage 3 a surface has its own colour: whether 200 is written as 199 is a matter of cutting 199.99….
    const Arguments stage{"--stage", "3"};
    run_glassbox({"render", "s.toml", "--stage", "3", "-o", "ours.png"}, {.folder = folder.path});
    const Image flat = folder.ours();
    const auto less = [&](int by) {
        return rearranged(flat, [&](const Image& image, int x, int y) {
            Rgb color = image.at(x, y);
            if (color.red == 200) color.red = static_cast<std::uint8_t>(200 - by);
            return color;
        });
    };
    CHECK(folder.compare(less(1), stage)["mistake"] == 0);
    CHECK(folder.compare(less(1), stage)["rounding"] > 0);
    CHECK(folder.compare(less(2), stage)["rounding"] == 0);
    CHECK(folder.compare(all_less(2))["mistake"] > 0);
}

TEST_CASE("what explains all of it is found: flipped, mirrored, shifted, swapped, another gamma") {
    const Pictures folder;
    const auto found = [&](const auto& place) {
        const json told = folder.compare(rearranged(folder.ours(), place));
        REQUIRE(told["found"].size() >= 1);
        CHECK(told["found"][0]["differ"] == 0);
        return told["found"][0]["ours"].get<std::string>();
    };
    CHECK(found([](const Image& o, int x, int y) { return o.at(x, 29 - y); }) == "flipped top to bottom");
    CHECK(found([](const Image& o, int x, int y) { return o.at(39 - x, y); }) == "flipped left to right");
    CHECK(found([](const Image& o, int x, int y) { return o.at(39 - x, 29 - y); }) == "turned by half a turn");
    CHECK(found([](const Image& o, int x, int y) { return x == 39 ? Rgb{} : o.at(x + 1, y); }) ==
          "shifted by a pixel to the left");
    CHECK(found([](const Image& o, int x, int y) { return y == 0 ? Rgb{} : o.at(x, y - 1); }) ==
          "shifted by a pixel down");
    CHECK(found([](const Image& o, int x, int y) {
              return Rgb{o.at(x, y).blue, o.at(x, y).green, o.at(x, y).red};
          }) == "with red and blue swapped");
    CHECK(found([](const Image& o, int x, int y) {
              const auto root = [](int byte) {
                  return static_cast<std::uint8_t>(std::lround(255 * std::sqrt(byte / 255.0)));
              };
              return Rgb{root(o.at(x, y).red), root(o.at(x, y).green), root(o.at(x, y).blue)};
          }) == "with a gamma of 2 applied to it, the square root");
}

TEST_CASE("the paper's figure: its program misses what it only touches, in 32 pixels, and that is no rounding") {
    const Folder folder;
    const std::string figure = SCENES "/../docs/figures/levental-2014.png", scene = SCENES "/levental-2014.toml";
    const Ran ran = run_glassbox({"compare", scene, figure, "--json"}, {.folder = folder.path});
    CHECK(ran.status == 1);
    CHECK(json::parse(ran.out)["differ"] == 32);
    CHECK(json::parse(ran.out)["mistake"] == 32);
    // By its own rule it is right in every pixel.
    CHECK(run_glassbox({"compare", scene, figure, "--sphere", "levental-2014"}, {.folder = folder.path}).status == 0);
}

TEST_CASE("pictures in float, of scenes in which float goes wrong, differ by float's rounding alone") {
    const Folder folder;
    for (const char* name : {"/spheres-grazing.toml", "/edges.toml"}) {
        const std::string scene = SCENES + std::string(name);
        run_glassbox({"render", scene, "--scalar", "float", "--sphere", "textbook", "-o", "theirs.png"},
                     {.folder = folder.path});
        const Ran ran =
            run_glassbox({"compare", scene, "theirs.png", "--precision", "float", "--json"}, {.folder = folder.path});
        CHECK(ran.status == 0);
        CHECK(json::parse(ran.out)["rounding"] > 100);
        CHECK(json::parse(ran.out)["unknown"] == 0);
    }
}

TEST_CASE("half a pixel to a side") {
    const Pictures folder;
    const auto found = [&](const char* corner) {
        std::string scene = content(folder / "s.toml");
        scene.replace(scene.find("corner = [0, 0, 9]"), 18, corner);
        write(folder / "moved.toml", scene);
        run_glassbox({"render", "moved.toml", "-o", "moved.png"}, {.folder = folder.path});
        const json told = folder.compare(read_picture(folder / "moved.png"));
        REQUIRE(told["found"].size() >= 1);
        CHECK(told["found"][0]["differ"] == 0);
        return told["found"][0]["ours"].get<std::string>();
    };
    // A view that begins further to the right shows the same things further to the left.
    CHECK(found("corner = [0.5, 0, 9]") == "shifted by half a pixel to the left");
    CHECK(found("corner = [-0.5, 0, 9]") == "shifted by half a pixel to the right");
    CHECK(found("corner = [0, 0.5, 9]") == "shifted by half a pixel down");
    CHECK(found("corner = [-0.5, -0.5, 9]") == "shifted by half a pixel to the right and up");
}

TEST_CASE("a picture of the differences has the picture, and its legend below") {
    const Pictures folder;
    Image theirs = folder.ours();
    theirs.at(5, 5).green = 77;
    folder.compare(theirs, {"-o", "why.png"});
    const Image why = read_picture(folder / "why.png");
    CHECK(why.width >= 200);  // 40 pixels, each a square of 5
    CHECK(why.height > 150);
    CHECK(std::ranges::count(why.pixels, Rgb{255, 150, 0}) >= 25);
}

TEST_CASE("what cannot be compared is refused, with what would be right") {
    const Pictures folder;
    write_ppm(folder / "small.ppm", Image(20, 10));
    check_refused(folder, {"compare", "s.toml", "small.ppm"}, 1,
                  {"small.ppm: error: it has 20x10 pixels", "40x30", "--size 20x10"});
    check_refused(folder, {"compare", "s.toml", "none.png"}, 1, {"none.png: error: there is no such file"});
    check_refused(folder, {"compare", "s.toml", "s.toml"}, 1,
                  {"s.toml: error: this is neither a PNG nor a binary PPM"});
    check_refused(folder, {"compare", "s.toml"}, 2, {"THEIRS.png: it is missing"});
    check_refused(folder, {"compare", "s.toml", "ours.png", "--rays", "r.csv"}, 2, {"--rays", "one at a time"});
    check_refused(folder, {"compare", "s.toml", "--rays", "r.csv"}, 2, {"--hits: it is missing"});
    check_refused(folder, {"compare", "s.toml", "--hits", "h.csv"}, 2, {"--rays: it is missing"});
    check_refused(folder, {"compare", "s.toml", "ours.png", "--scalar", "float"}, 2, {"--scalar", "--precision"});
    check_refused(folder, {"compare", "s.toml", "ours.png", "--precision", "half"}, 2,
                  {"--precision: 'half' is not known"});
    check_refused(folder, {"compare", "s.toml", "ours.png", "--worst", "-1"}, 2, {"--worst"});
    check_refused(folder, {"compare", "s.toml", "ours.png", "-o", "ours.png"}, 1,
                  {"ours.png: error: this file is read"});
    check_refused(folder, {"compare", "s.toml", "ours.png", "-o", "why.txt"}, 1, {"why.txt: error: unknown extension"});
}
