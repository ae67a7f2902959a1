// `glassbox render`: the picture is right, and is written to the right file.
#include <doctest.h>

#include "cli/program.hpp"
#include "cli/tiny_scene.hpp"

using namespace glassbox::test;

namespace {

namespace fs = std::filesystem;

/// The tiny scene's picture without shading: the ball's cross of five pixels before the background.
std::string tiny_ppm() {
    const std::string background = "\x01\x02\x03", ball("\xff\0\0", 3);
    std::string all = "P6\n4 3\n255\n";
    for (const char* row : {".o..",   //
                            "ooo.",   //
                            ".o.."})  //
        for (const char* pixel = row; *pixel; ++pixel) all += *pixel == 'o' ? ball : background;
    return all;
}

/// A picture without its comments.
std::string ppm(const fs::path& file) { return without_comments(content(file)); }

/// A folder with only s.toml.
struct Workplace : Folder {
    Workplace() { write(*this / "s.toml", tiny_scene); }

    /// Renders there; succeeds, and prints only what is returned.
    std::string render(const Arguments& more) const {
        Arguments arguments{"render"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        const Ran ran = run_glassbox(arguments, {.folder = path});
        CHECK(ran.status == 0);
        CHECK(ran.err == "");
        return ran.out;
    }
};

}  // namespace

TEST_CASE("a picture's pixels, from the top left") {
    const Workplace folder;
    CHECK(folder.render({"s.toml", "--stage", "2", "-o", "o.ppm"}) == "");
    CHECK(ppm(folder / "o.ppm") == tiny_ppm());
    CHECK(folder.entries() == 2);
}

TEST_CASE("options change the picture: stage 1 shows no ball, a factor of 0 and no light leave it black") {
    const Workplace folder;
    folder.render({"s.toml", "--stage", "1", "-o", "1.ppm"});
    CHECK(ppm(folder / "1.ppm") != tiny_ppm());
    folder.render({"s.toml", "--ambient", "0", "--diffuse", "0", "--specular", "0", "-o", "2.ppm"});
    std::string black = tiny_ppm();
    for (std::size_t i = 11; i < black.size(); ++i)
        if (black[i] == '\xff') black[i] = '\0';
    CHECK(ppm(folder / "2.ppm") == black);
    // Half a turn about y mirrors z about 0: rows 1 and 2 from below are now at z = −1 and −2, under the ball.
    folder.render({"s.toml", "--turn", "y:180", "-o", "3.ppm"});
    std::string background;
    for (int pixel = 0; pixel < 8; ++pixel) background += "\x01\x02\x03";
    CHECK(ppm(folder / "3.ppm").substr(11, 24) == background);
}

TEST_CASE("--size: pixels, for every shape") {
    const Workplace folder;
    for (const char* shape : {"1x1", "1x100", "100x1", "7X5"}) {
        folder.render({"s.toml", "--size", shape, "-o", "o.ppm"});
        std::string expected(shape);
        expected[expected.find_first_of("xX")] = ' ';
        CHECK(ppm(folder / "o.ppm").starts_with("P6\n" + expected + "\n255\n"));
    }
}

TEST_CASE("PNG: its signature, then width and height") {
    const Workplace folder;
    folder.render({"s.toml", "--out", "o.png"});
    const std::string start("\x89PNG\r\n\x1a\n\0\0\0\x0dIHDR\0\0\0\4\0\0\0\3\x08\2", 26);  // 8 bits a channel, RGB
    CHECK(content(folder / "o.png").starts_with(start));
}

TEST_CASE("without -o the picture is the scene's name and .png, here; its path is printed") {
    const Workplace folder;
    fs::create_directory(folder / "scenes");
    write(folder / "scenes/my.first.toml", tiny_scene);
    const fs::path here = fs::canonical(folder.path);
    CHECK(folder.render({"scenes/my.first.toml"}) == (here / "my.first.png").string() + "\n");
    CHECK(fs::exists(folder / "my.first.png"));
    CHECK(folder.render({"triangle", "--size", "4x4"}) == (here / "triangle.png").string() + "\n");
    CHECK(folder.entries() == 4);
}

TEST_CASE("the scenes that come with Glassbox are known by name anywhere, a file of one's own first") {
    const Workplace folder;
    for (const char* name : {"sphere", "sphere.toml", "scenes/sphere", "scenes/sphere.toml"}) {
        folder.render({name, "--size", "5x5", "-o", "o.ppm"});
        CHECK(ppm(folder / "o.ppm").starts_with("P6\n5 5\n"));
    }
    write(folder / "sphere.toml", tiny_scene);
    folder.render({"sphere.toml", "-o", "o.ppm"});
    CHECK(ppm(folder / "o.ppm").starts_with("P6\n4 3\n"));
    fs::create_directory(folder / "triangle");  // does not hide the scene of that name
    folder.render({"triangle", "--size", "5x5", "-o", "o.ppm"});
}

TEST_CASE("names with spaces, in UTF-8, with capitals, beginning with a dash, or of a file that is there already") {
    const Workplace folder;
    for (const char* name : {"my picture.ppm", "Größe 𝄞.ppm", "O.PPM", "-o.ppm", "O.PPM"}) {
        folder.render({"s.toml", "--stage", "2", "-o", name});
        CHECK(ppm(folder / name) == tiny_ppm());
    }
    write(folder / "schöne Szene.toml", tiny_scene);
    write(folder / "-s.toml", tiny_scene);
    folder.render({"schöne Szene.toml", "-o", "1.ppm"});
    folder.render({"-o", "2.ppm", "--", "-s.toml"});
    CHECK(ppm(folder / "1.ppm") == ppm(folder / "2.ppm"));
    CHECK(folder.entries() == 9);
}

TEST_CASE("neither an environment nor open standard streams are needed") {
    const Workplace folder;
    const Arguments arguments{"render", "s.toml", "--stage", "2", "-o", "o.ppm"};
    CHECK(run_glassbox(arguments, {.folder = folder.path, .empty_environment = true}).status == 0);
    fs::remove(folder / "o.ppm");
    CHECK(run_glassbox(arguments, {.folder = folder.path, .in = nullptr, .out = nullptr, .err = nullptr}).status == 0);
    CHECK(ppm(folder / "o.ppm") == tiny_ppm());
}

TEST_CASE("an empty scene is a picture of its background") {
    const Workplace folder;
    write(folder / "empty.toml", "");
    folder.render({"empty.toml", "--size", "1x1", "-o", "o.ppm"});
    CHECK(ppm(folder / "o.ppm") == std::string("P6\n1 1\n255\n\0\0\0", 14));
}

TEST_CASE("an option that the stage leaves unused is noted in one line, and all is done") {
    const Workplace folder;
    const auto noted = [&](const Arguments& more) {
        Arguments arguments{"render", "s.toml", "-o", "o.ppm"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        const Ran ran = run_glassbox(arguments, {.folder = folder.path});
        CHECK(ran.status == 0);
        return ran.err;
    };
    CHECK(noted({"--stage", "4", "--turn", "z:10"}) == "glassbox render: note: not used: --turn (from stage 5)\n");
    CHECK(noted({"--stage", "3", "--ambient", "1", "--shading", "phong"}) ==
          "glassbox render: note: not used: --ambient (from stage 4), --shading (from stage 4)\n");
    CHECK(noted({"--stage", "2", "--triangle", "tolerance"}) ==
          "glassbox render: note: not used: --triangle (from stage 3)\n");
    CHECK(noted({"--stage", "1", "--sphere", "textbook"}) ==
          "glassbox render: note: not used: --sphere (from stage 2)\n");
    CHECK(noted({"--stage", "2", "--sphere", "textbook", "--threads", "1", "--size", "2x2"}) == "");
    CHECK(noted({"--turn", "z:10", "--ambient", "1", "--triangle", "tolerance:0.5"}) == "");
    for (const Arguments& rule : {Arguments{"--sphere", "levental-2014"}, Arguments{"--triangle", "tolerance"}}) {
        CHECK(noted(rule) == "");
        CHECK(noted({rule[0], rule[1], "--engine", "fast"}) ==
              "glassbox render: note: not used: --engine fast (only for certified answers, not by the rules tolerance "
              "and levental-2014)\n");
    }
}
