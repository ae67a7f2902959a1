#include <doctest.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>

#include "learn/course/progress.hpp"
#include "learn/picture/maker.hpp"
#include "learn/prepared.hpp"
#include "output/folder.hpp"
#include "render/job.hpp"
#include "render/render.hpp"
#include "render/view.hpp"
#include "scene/scene_file.hpp"

using namespace glassbox;
using namespace glassbox::learn;
using namespace glassbox::learn::mine;
namespace fs = std::filesystem;

namespace {

/// A learner's folder for this test, with the solutions of a lesson.
struct Learner {
    test::Folder folder;
    Workspace workspace = open_workspace(ROOT, folder.path);
    test::Prepared prepared{workspace.hidden()};
    Maker maker;
    std::vector<PictureUpdate> told;

    const Exercise& exercise(int number) const { return exercise_called(workspace, std::to_string(number)); }

    void write(const Exercise& of, const std::string& header, const std::string& text) const {
        const fs::path path = workspace.header(of, header);
        fs::create_directories(path.parent_path());
        std::ofstream(path) << text;
    }
    std::string solution(const Exercise& of, const std::string& header) const {
        return test::content(workspace.solution(of, header));
    }
    void solve(const Exercise& of) const {
        for (const std::string& header : of.headers) write(of, header, solution(of, header));
    }
    /// The solution with one text replaced by another.
    void mistake(const Exercise& of, const std::string& header, const std::string& instead_of,
                 const std::string& put) const {
        std::string text = solution(of, header);
        const std::size_t at = text.find(instead_of);
        REQUIRE(at != std::string::npos);
        write(of, header, text.replace(at, instead_of.size(), put));
    }

    /// Returns the last update of a picture.
    PictureUpdate draw(const Exercise& of, const Scene& scene, const Options& options) {
        told.clear();
        maker.make(workspace, {&of}, scene, options, [&](PictureUpdate update) { told.push_back(std::move(update)); });
        REQUIRE(!told.empty());
        return told.back();
    }
    /// The same, drawn by all lessons that are finished.
    PictureUpdate draw_with_all(const Scene& scene) {
        told.clear();
        Options options;
        options.scalar = Scalar::double_;
        maker.make_with_all(workspace, scene, options,
                            [&](PictureUpdate update) { told.push_back(std::move(update)); });
        REQUIRE(!told.empty());
        return told.back();
    }
};

Scene paper() { return read_scene(ROOT "/scenes/levental-2014.toml"); }

Options in_double(int stage) {
    Options options;
    options.stage = stage;
    options.scalar = Scalar::double_;
    return options;
}

}  // namespace

TEST_CASE("the solutions draw what we draw, to the last pixel, at every stage") {
    Learner learner;
    const Scene scene = paper();
    for (int stage = 1; stage <= 5; ++stage) {
        CAPTURE(stage);
        const Exercise& exercise = learner.exercise(stage);
        learner.solve(exercise);
        const PictureUpdate update = learner.draw(exercise, scene, in_double(stage));
        CHECK(update.stand == Stand::drawn);
        CHECK(update.words == "");
        CHECK(update.compile_seconds > 0);
        REQUIRE(update.drawing);
        CHECK(update.drawing->drawn == 500 * 500);
        CHECK(update.drawing->not_numbers == 0);
        CHECK(update.drawing->image.pixels == render(scene, in_double(stage)).pixels);
    }
    // The last lesson, compiled already, with a pinhole and a mesh; and with other rules, turned.
    const Exercise& turns = learner.exercise(5);
    Options options = in_double(5);
    options.turns = {{Axis::z, 20}, {Axis::y, -10}};
    options.accumulated = true;
    const Scene room = resized(read_scene(ROOT "/scenes/room.toml"), 37, 23);
    PictureUpdate update = learner.draw(turns, room, options);
    CHECK(update.compile_seconds == 0);
    CHECK(learner.told.front().stand != Stand::compiling);
    CHECK(update.drawing->image.pixels == render(room, options).pixels);
    options.sphere_rule = Textbook{};
    options.triangle_rule = Tolerance{25};
    update = learner.draw(turns, scene, options);
    CHECK(update.compile_seconds > 0);
    CHECK(update.drawing->image.pixels == render(scene, options).pixels);
    options.sphere_rule = Levental2014{};
    options.triangle_rule = MoellerTrumbore{};
    update = learner.draw(turns, room, options);
    CHECK(update.stand == Stand::drawn);
    CHECK(update.drawing->image.pixels == render(room, options).pixels);
}

TEST_CASE("what is not begun, deleted or not written is told, and how to go on") {
    Learner learner;
    const Exercise& spheres = learner.exercise(2);
    const Scene scene = paper();
    PictureUpdate update = learner.draw(spheres, scene, in_double(2));
    CHECK(update.stand == Stand::not_there);
    CHECK(update.words.find("2-spheres is not begun: './glassbox learn test 2' makes the files that you write") !=
          std::string::npos);

    for (const std::string& header : spheres.headers)
        learner.write(spheres, header, learner.workspace.starter(spheres, header));
    update = learner.draw(spheres, scene, in_double(2));
    CHECK(update.stand == Stand::not_written);
    CHECK(update.spot == std::nullopt);  // it is the same at every pixel
    CHECK(update.words.find("`chord` is not written yet (") == 0);
    CHECK(update.words.find("2-spheres/chord.hpp:") != std::string::npos);

    // There are two rules for the roots: one of them may be missing.
    for (const std::string& header : spheres.headers)
        if (header != "chord.hpp") learner.write(spheres, header, learner.solution(spheres, header));
    update = learner.draw(spheres, scene, in_double(2));
    INFO(update.words);
    CHECK(update.words.find("`chord` is not written yet (") == 0);
    CHECK(update.words.find("until it is, another rule can be chosen in the controls") != std::string::npos);
    Options textbook = in_double(2);
    textbook.sphere_rule = Textbook{};
    update = learner.draw(spheres, scene, textbook);
    CHECK(update.stand == Stand::drawn);

    Exercise speed = spheres;  // like a lesson whose headers no tracer of ours includes
    speed.number = 7, speed.name = "7-speed", speed.own_picture = OwnPicture::none;
    update = learner.draw(speed, scene, in_double(2));
    CHECK(update.stand == Stand::not_there);
    CHECK(update.words.find("'./glassbox learn picture 7' draws one that is") != std::string::npos);

    fs::remove(learner.workspace.header(spheres, "sphere.hpp"));
    update = learner.draw(spheres, scene, in_double(2));
    CHECK(update.stand == Stand::not_there);
    CHECK(update.words.find("sphere.hpp: error: there is no such file: was it deleted, or renamed?") !=
          std::string::npos);
    CHECK(update.drawing == nullptr);
}

TEST_CASE("what does not compile is told at its line, even if it is wrong in a hundred ways") {
    Learner learner;
    const Exercise& spheres = learner.exercise(2);
    learner.solve(spheres);
    learner.mistake(spheres, "chord.hpp", "const Real m = -dot(v, D);", "const Real m = -dott(v, D);");
    PictureUpdate update = learner.draw(spheres, paper(), in_double(2));
    CHECK(update.stand == Stand::does_not_compile);
    REQUIRE(update.error);
    CHECK(update.error->yours);
    CHECK(fs::path(update.error->place.file).filename() == "chord.hpp");
    const std::string text = test::content(learner.workspace.header(spheres, "chord.hpp"));
    const auto line = 1 + std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(text.find("dott")), '\n');
    CHECK(update.error->place.line == static_cast<std::size_t>(line));
    CHECK(update.words.find("dott") != std::string::npos);
    CHECK(learner.told.front().stand == Stand::compiling);

    std::string hundred;
    for (int i = 0; i < 100; ++i) hundred += "struct { { ( [ template <class> > = ; #if }\n@ $ '\n";
    learner.write(spheres, "sphere.hpp", hundred);
    update = learner.draw(spheres, paper(), in_double(2));
    CHECK(update.stand == Stand::does_not_compile);
    CHECK(update.words != "");
    CHECK(update.drawing == nullptr);

    learner.solve(spheres);
    CHECK(learner.draw(spheres, paper(), in_double(2)).stand == Stand::drawn);
}

TEST_CASE("hostile code is told in words, at its pixel, and what it drew before stays") {
    Learner learner;
    const Exercise& spheres = learner.exercise(2);
    learner.solve(spheres);
    // The ray of column j and row i starts at (500, j, i), and pixel (x, y) is column x, row 499 − y: this is (240,
    // 128), one of the first that are drawn.
    learner.mistake(spheres, "chord.hpp", "const Real a = dot(D, D);\n",
                    "const Real a = dot(D, D);\n    if (ray.P.y == 240 && ray.P.z == 371) hostile();\n");
    std::string text = test::content(learner.workspace.header(spheres, "chord.hpp"));
    text.replace(text.find("namespace glassbox {"), 0, R"(
#include <cstdio>
#include <algorithm>
#include <cstdlib>
#include <stdexcept>
#include <string>
#include <vector>
inline volatile int zero = 0, one = 1;
inline double* volatile null = nullptr;
inline int without_end(int n) { return n == -1 ? 0 : without_end(n + one) + 1; }
inline void hostile() {
    const std::string kind = std::getenv("GLASSBOX_TEST_KIND");
    if (kind == "null") *null = 1;
    if (kind == "stack") without_end(0);
    if (kind == "loop") while (one) {}
    if (kind == "print") while (one) std::puts("I am here, and here, and here, and here, and here, and here, and here");
    if (kind == "exit") std::exit(0);
    if (kind == "abort") std::abort();
    if (kind == "exception") throw std::runtime_error("the radius is negative");
    if (kind == "divide") zero = one / 2 + 7 / zero;
    if (kind == "memory") while (one) static_cast<void>(new char[std::size_t{64} << 20]);
    if (kind == "say") std::puts("hello");
}
)");
    learner.write(spheres, "chord.hpp", text);
    const Scene scene = paper();
    const Image ours = render(scene, in_double(2));
    const auto end = [&](const char* kind) {
        ::setenv("GLASSBOX_TEST_KIND", kind, 1);
        return learner.draw(spheres, scene, in_double(2));
    };
    const std::pair<const char*, const char*> kinds[] = {
        {"null", "at pixel (240, 128) it followed a null pointer (address 0x0)"},
        {"stack", "at pixel (240, 128) its stack overflowed: a function that calls itself without end?"},
        {"loop", "at pixel (240, 128) it ran for 3 s without ending: an endless loop?"},
        {"exit", "at pixel (240, 128) it called exit(0) before its work was done"},
        {"abort", "at pixel (240, 128) it gave up (abort)"},
        {"exception", "at pixel (240, 128) it threw an exception that nobody caught: the radius is negative"},
#if defined(__x86_64__) || defined(__i386__)  // elsewhere 7 / 0 may be a number
        {"divide", "at pixel (240, 128) it divided a whole number by zero"},
#endif
    };
    for (const auto& [kind, words] : kinds) {
        const PictureUpdate update = end(kind);
        CHECK(update.stand == Stand::failed);
        CHECK(update.words == words);
        CHECK(update.spot == Pixel{240, 128});
        REQUIRE(update.drawing);
        // The coarse pixels before it, 16 apart, are drawn: 8 rows of 32, and 15 of the ninth. (0, 0) lies on the
        // border.
        CHECK(update.drawing->drawn == 8 * 32 + 15);
        CHECK(update.drawing->states[240 + 500 * 128] == SheetPixel::not_drawn);
        CHECK(update.drawing->image.at(224, 128) == ours.at(224, 128));
    }
    const PictureUpdate print = end("print");
    CHECK(print.stand == Stand::failed);
    CHECK(print.spot == Pixel{240, 128});
    CHECK(print.words.find("without ending: an endless loop") != std::string::npos);  // by time, or by output
    CHECK(print.said.find("I am here, and here") == 0);
    const PictureUpdate memory = end("memory");
    CHECK(memory.spot == Pixel{240, 128});
    CHECK(memory.words.find("at pixel (240, 128) it asked for more memory than it may have (10") == 0);
    const PictureUpdate fine = end("say");
    CHECK(fine.stand == Stand::drawn);
    CHECK(fine.spot == std::nullopt);
    CHECK(fine.said == "hello\nhello\n");  // there are two spheres
    CHECK(fine.drawing->image.pixels == ours.pixels);
}

TEST_CASE("numbers that are none are counted, and their pixels known") {
    Learner learner;
    const Exercise& spheres = learner.exercise(2);
    learner.solve(spheres);
    // 0/0 in every root. Comparisons with NaN are false: everything is missed.
    learner.mistake(spheres, "quadratic.hpp",
                    "return {(-b - root_of_discriminant) / a, (-b + root_of_discriminant) / a};",
                    "const Real none = (b - b) / (a - a);\n    return {none, none};");
    Options textbook = in_double(2);
    textbook.sphere_rule = Textbook{};
    const Scene scene = paper();
    const PictureUpdate update = learner.draw(spheres, scene, textbook);
    CHECK(update.stand == Stand::drawn);
    // The pixels whose rays meet a sphere's line: with the solution, those that are not background. From the top left
    // the first is the top of the green sphere: centre row 350, radius 50, so row 400, y = 99, at column 350.
    Scene plain = scene;
    plain.border.reset();
    const Image ours = render(plain, textbook);
    const auto hit =
        std::count_if(ours.pixels.begin(), ours.pixels.end(), [&](Rgb c) { return c != scene.background; });
    CHECK(update.drawing->not_numbers == hit);
    CHECK(update.spot == Pixel{350, 99});
    CHECK(update.words ==
          std::to_string(hit) + " pixels are made of something that is not a number (NaN), the first at (350, 99)");
    CHECK(update.drawing->states[350 + 500 * 99] == SheetPixel::not_a_number);
    CHECK(update.drawing->states[350 + 500 * 98] == SheetPixel::drawn);
}

TEST_CASE("lesson 6: what bounds prove is true; what they leave open is counted") {
    Learner learner;
    const Exercise& rounding = learner.exercise(6);
    learner.solve(rounding);
    const Scene scene = resized(read_scene(ROOT "/scenes/mesh-far.toml"), 120, 90);
    Options certified;
    const Image truth = render(scene, certified);
    PictureUpdate update = learner.draw(rounding, scene, certified);
    CHECK(update.stand == Stand::drawn);
    REQUIRE(update.drawing);
    CHECK(update.drawing->drawn == 120 * 90);
    const auto wrong = [&] {
        int pixels = 0;
        for (std::size_t i = 0; i < truth.pixels.size(); ++i)
            pixels +=
                update.drawing->states[i] == SheetPixel::drawn && update.drawing->image.pixels[i] != truth.pixels[i];
        return pixels;
    };
    CHECK(wrong() == 0);
    CHECK(update.drawing->undecided > 0);
    CHECK(update.drawing->undecided < update.drawing->drawn);
    // The nearest of the six fills the first quarter of the picture's width in its upper half: nothing is undecided
    // there.
    for (int y = 0; y < 20; ++y)
        CHECK(update.drawing->states[static_cast<std::size_t>(120 * y + 20)] == SheetPixel::drawn);
    CHECK(update.spot == update.drawing->first_undecided);
    CHECK(update.words.find("undecided: the bounds leave open what is seen there; the first is (") !=
          std::string::npos);

    // A bound that is far too small "proves" what is wrong.
    learner.mistake(rounding, "filter.hpp", "return 9 * u * size;", "return 1e-9 * u * size;");
    update = learner.draw(rounding, scene, certified);
    CHECK(update.stand == Stand::drawn);
    CHECK(wrong() > 0);
}

TEST_CASE("all that is written, at once: the mistakes of two lessons show in one picture") {
    Learner learner;
    const Exercise &spheres = learner.exercise(2), &triangles = learner.exercise(3), &shading = learner.exercise(4);
    const Scene scene = resized(paper(), 100, 100);
    PictureUpdate update = learner.draw_with_all(scene);
    CHECK(update.stand == Stand::not_there);
    CHECK(update.words == "no lesson of yours is begun yet; './glassbox learn test' makes the files that you write");

    // A lesson that is begun and not finished is ours.
    const std::string starter = learner.workspace.starter(shading, "reflection.hpp");
    learner.write(shading, "reflection.hpp", starter);
    update = learner.draw_with_all(scene);
    CHECK(update.stand == Stand::not_there);
    CHECK(update.words ==
          "no lesson of yours is finished yet; lesson 4 waits for `positive_part`; "
          "'./glassbox learn test 4' says what comes next");

    // Normals that are not of length 1 are seen in the shading; each pixel shows a sphere, a triangle or neither.
    learner.solve(spheres);
    learner.mistake(spheres, "sphere.hpp", "return unit(X - sphere.C);", "return X - sphere.C;");
    learner.solve(triangles);
    learner.mistake(triangles, "triangle.hpp", "return unit(cross(B - A, C - A));", "return cross(A - B, C - A);");
    update = learner.draw_with_all(scene);
    INFO(update.words);
    CHECK(update.stand == Stand::drawn);
    CHECK(update.words == "");
    CHECK(update.by_whom == "drawn by lessons 2 and 3 of yours; lesson 4 waits for `positive_part`; the rest is ours");
    REQUIRE(update.drawing);
    const auto all = update.drawing->image.pixels, ours = render(scene, in_double(5)).pixels;
    const auto by_spheres = learner.draw(spheres, scene, in_double(5)).drawing->image.pixels;
    const auto by_triangles = learner.draw(triangles, scene, in_double(5)).drawing->image.pixels;
    int wrong_spheres = 0, wrong_triangles = 0;
    for (std::size_t i = 0; i < ours.size(); ++i) {
        wrong_spheres += by_spheres[i] != ours[i];
        wrong_triangles += by_triangles[i] != ours[i];
        CHECK(all[i] == (by_spheres[i] != ours[i] ? by_spheres[i] : by_triangles[i]));
    }
    CHECK(wrong_spheres > 0);
    CHECK(wrong_triangles > 0);

    // A stub that is commented out is no longer one; a file that was deleted makes its lesson ours.
    learner.write(shading, "reflection.hpp",
                  learner.solution(shading, "reflection.hpp") +
                      "// return not_written<Real>(\"diffuse\");\n/* return not_written<Real>(\"diffuse\"); */\n");
    fs::remove(learner.workspace.header(triangles, "sides.hpp"));
    update = learner.draw_with_all(scene);
    CHECK(update.stand == Stand::drawn);
    CHECK(update.by_whom ==
          "drawn by lessons 2 and 4 of yours; lesson 3 waits for its file sides.hpp; the rest is ours");
    CHECK(update.drawing->image.pixels == by_spheres);
    CHECK(learner.draw_with_all(scene).compile_seconds == 0);
}

TEST_CASE("all that is written, at once: an error is told in the file of the lesson where it is") {
    Learner learner;
    const Exercise &spheres = learner.exercise(2), &triangles = learner.exercise(3);
    const Scene scene = resized(paper(), 20, 20);
    learner.solve(spheres);
    learner.solve(triangles);
    learner.mistake(triangles, "triangle.hpp", "return unit(cross(B - A, C - A));", "return unit(cros(B - A, C - A));");
    PictureUpdate update = learner.draw_with_all(scene);
    CHECK(update.stand == Stand::does_not_compile);
    CHECK(update.by_whom == "drawn by lessons 2 and 3 of yours; the rest is ours");
    REQUIRE(update.error);
    CHECK(update.error->yours);
    CHECK(update.error->place.file == learner.workspace.header(triangles, "triangle.hpp").string());
    CHECK(update.error->source.find("cros(B - A") != std::string::npos);

    // What is not closed in one lesson's file, the compiler finds in another's.
    learner.solve(triangles);
    learner.mistake(spheres, "sphere.hpp", "return unit(X - sphere.C);\n}", "return unit(X - sphere.C);\n");
    update = learner.draw_with_all(scene);
    CHECK(update.stand == Stand::does_not_compile);
    REQUIRE(update.error);
    CHECK(update.error->yours);
    CHECK(update.error->place.file == learner.workspace.header(spheres, "sphere.hpp").string());

    for (const int number : {1, 2, 4, 5}) learner.solve(learner.exercise(number));
    update = learner.draw_with_all(scene);
    CHECK(update.by_whom == "drawn by lessons 1, 2, 3, 4 and 5 of yours");
    CHECK(update.drawing->image.pixels == render(scene, in_double(5)).pixels);
}

TEST_CASE("a drawing can be stopped") {
    Learner learner;
    const Exercise& spheres = learner.exercise(2);
    learner.solve(spheres);
    std::stop_source source;
    source.request_stop();
    CHECK_THROWS_AS(
        learner.maker.make(
            learner.workspace, {&spheres}, paper(), in_double(2), [](const PictureUpdate&) {}, source.get_token()),
        Cancelled);
}

TEST_CASE("the lesson where the learner is") {
    Learner learner;
    const fs::path file = learner.workspace.hidden() / "progress.json";
    const auto present = [&] {
        std::string complaint;
        return present_exercise(learner.workspace, read_progress(file, complaint)).number;
    };
    CHECK(present() == 1);
    learner.solve(learner.exercise(3));
    CHECK(present() == 3);  // begun, so it is the present lesson
    learner.solve(learner.exercise(2));
    CHECK(present() == 2);
    fs::create_directories(learner.workspace.hidden());
    Progress progress;
    progress.lessons["2-spheres"].passed = true;
    write_progress(file, progress);
    CHECK(present() == 3);
}

TEST_CASE("each pixel is drawn once, whatever the size") {
    for (const auto& [width, height] : {std::pair{1, 1}, {16, 16}, {17, 33}, {500, 3}}) {
        std::vector<int> times(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), 0);
        coarse_first(width, height, [&, w = width](int x, int y) { ++times[static_cast<std::size_t>(y * w + x)]; });
        CHECK(std::all_of(times.begin(), times.end(), [](int n) { return n == 1; }));
    }
}
