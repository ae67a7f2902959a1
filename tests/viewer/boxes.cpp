// The engine's boxes, level by level: what is drawn exists, and what the pinned ray does is what the search does.
#include "viewer/model/space/boxes_in_space.hpp"

#include <doctest.h>

#include <algorithm>
#include <map>
#include <span>

#include "../certified/cases.hpp"
#include "cli/program.hpp"
#include "render/job.hpp"
#include "render/measure/channel.hpp"
#include "render/measure/measurements.hpp"
#include "render/render.hpp"
#include "render/search/build_engine.hpp"
#include "render/search/certified_search.hpp"
#include "render/view.hpp"
#include "scene/scene_file.hpp"
#include "viewer/hidden_viewer.hpp"
#include "viewer/model/state/keys.hpp"

using namespace glassbox;
using engine::Child;

namespace {

const std::filesystem::path scenes = SCENES;

BoxLevels levels_of(const Scene& scene, int stage = 5) { return box_levels(build_engine(scene, stage, 1)); }

/// All boxes of a level, no sample.
std::vector<BoxInSpace> all_on(const BoxLevels& levels, int level) {
    return boxes_on_level(levels, level, nullptr, levels.boxes).drawn;
}

bool lies_in(const Vec3<double>& least, const Vec3<double>& greatest, const BoxInSpace& box) {
    return least.x >= box.least.x && least.y >= box.least.y && least.z >= box.least.z && greatest.x <= box.greatest.x &&
           greatest.y <= box.greatest.y && greatest.z <= box.greatest.z;
}

/// The least and greatest corner of a surface.
std::pair<Vec3<double>, Vec3<double>> extent(const Sphere<double>& s) {
    const Vec3<double> r{s.r, s.r, s.r};
    return {s.C - r, s.C + r};
}
std::pair<Vec3<double>, Vec3<double>> extent(const Triangle<double>& t) {
    const auto& [A, B, C] = t;
    return {{std::min({A.x, B.x, C.x}), std::min({A.y, B.y, C.y}), std::min({A.z, B.z, C.z})},
            {std::max({A.x, B.x, C.x}), std::max({A.y, B.y, C.y}), std::max({A.z, B.z, C.z})}};
}

/// 300 spheres and 2000 triangles, of all sizes, far from the world's origin.
Scene crowd() {
    test::Rays rays(7);
    Scene scene;
    const Vec3<double> middle{1000, -2000, 500};
    for (int i = 0; i < 300; ++i)
        scene.spheres.push_back({middle + 20.0 * rays.anywhere(), rays.random.positive(-6, 1), {}});
    for (int i = 0; i < 2000; ++i) {
        const Vec3<double> at = middle + 20.0 * rays.anywhere();
        const double size = rays.random.positive(-6, 2);
        scene.triangles.push_back(
            {{at + size * rays.anywhere(), at + size * rays.anywhere(), at + size * rays.anywhere()}, {}});
    }
    return scene;
}

/// Eight spheres of radius 1 about x = 300, and eight about x = 0, on a ring of radius 10 but for the first of each,
/// which the paper's ray of column 250 and row 250 passes through.
Scene two_clusters() {
    Scene scene;
    for (const double x : {300.0, 0.0})
        for (int i = 0; i < 8; ++i) {
            const auto [c, s] = cos_sin(45.0 * i);
            const double ring = i == 0 ? 0 : 10;
            scene.spheres.push_back({{x, 250 + ring * c, 250 + ring * s}, 1, {}});
        }
    return scene;
}

/// The boxes above each surface: its leaf's code first, the root's last.
std::map<std::uint32_t, std::vector<std::uint32_t>> ways_up(const engine::Engine& all) {
    std::map<std::uint32_t, std::vector<std::uint32_t>> result;
    const engine::Hierarchy& tree = all.hierarchy();
    std::map<std::uint32_t, std::uint32_t> parent;
    for (std::uint32_t n = 0; n < tree.nodes.size(); ++n)
        for (const std::uint32_t child : tree.nodes[n].child)
            if (child != Child::nothing) parent[child] = n;
    for (const auto& entry : parent) {
        const std::uint32_t leaf = entry.first;
        if (!Child::is_leaf(leaf)) continue;
        const auto [first, count] =
            (Child::is_of_spheres(leaf) ? tree.sphere_leaves : tree.triangle_leaves)[Child::index(leaf)];
        for (const std::uint32_t surface : std::span(tree.surfaces).subspan(first, count))
            for (std::uint32_t code = leaf;; code = parent.at(code)) {
                result[surface].push_back(code);
                if (code == 0) break;
            }
    }
    return result;
}

/// A probe that records which surfaces a search meets.
struct MetSurfaces {
    std::vector<std::uint32_t> numbers;

    template <class What, class... Values>
    void operator()(What, const Values&...) {}
    template <class Real>
    void operator()(told::Met, std::size_t surface, const Real&) {
        numbers.push_back(static_cast<std::uint32_t>(surface));
    }
};

bool holds(const std::vector<std::uint32_t>& codes, std::uint32_t code) {
    return std::binary_search(codes.begin(), codes.end(), code);
}

/// A state and its results, as far as boxes need them.
struct Shown {
    ViewerState state;
    Results results;
    Boxes boxes;

    explicit Shown(const Scene& scene, int stage = 5) {
        state.scene = std::make_shared<const Scene>(scene);
        Setup setup = setup_of(scene);
        setup.options.stage = stage;
        state.setup = History(setup);
        results.boxes = std::make_shared<const BoxLevels>(levels_of(scene, stage));
    }
    void pin(int x, int y) {
        Story story;
        story.ray = pixel_ray(view(*state.scene, state.setup.now().options), x, y, state.scene->height);
        results.story = std::make_shared<const Story>(story);
    }
    const BoxesInWords& words(int level) {
        state.box_level = level;
        boxes.update(state, results);
        return boxes.words();
    }
};

}  // namespace

TEST_CASE("on each level the boxes hold every surface, and each lies in one of the level above") {
    for (const Scene& scene : {crowd(), read_scene(scenes / "room.toml"), read_scene(scenes / "levental-2014.toml")}) {
        const BoxLevels levels = levels_of(scene);
        REQUIRE(levels.deepest() >= 1);
        CHECK(levels.on_level[0] == 1);
        CHECK(levels.on_level[1] <= engine::fan_out);
        std::vector<BoxInSpace> above;
        for (int level = 0; level <= levels.deepest(); ++level) {
            CAPTURE(level);
            const std::vector<BoxInSpace> here = all_on(levels, level);
            CHECK(here.size() == levels.on_level[static_cast<std::size_t>(level)]);
            std::size_t outside = 0, orphans = 0;
            for (std::size_t i = 0; i < levels.engine->size(); ++i) {
                const auto its = levels.engine->with_surface(i, [](const auto& surface) { return extent(surface); });
                outside += std::none_of(here.begin(), here.end(),
                                        [&](const BoxInSpace& box) { return lies_in(its.first, its.second, box); });
            }
            for (const BoxInSpace& box : here)
                orphans += level > 0 && std::none_of(above.begin(), above.end(), [&](const BoxInSpace& parent) {
                               return lies_in(box.least, box.greatest, parent);
                           });
            CHECK(outside == 0);
            CHECK(orphans == 0);
            above = here;
        }
        // Below the deepest level there is nothing: all are leaves.
        const engine::Hierarchy& tree = levels.engine->hierarchy();
        CHECK(above.size() == tree.triangle_leaves.size() + tree.sphere_leaves.size());
        CHECK(levels.boxes == tree.nodes.size() + above.size());
    }
}

TEST_CASE("the paper's scene: a box around all, and in it one for the spheres and one for the tetrahedron") {
    const BoxLevels levels = levels_of(read_scene(scenes / "levental-2014.toml"));
    CHECK(levels.on_level == std::vector<std::size_t>{1, 2});
    CHECK(levels.boxes == 3);
    // Spheres: (100, 350, 350) r 50 and (50, 300, 300) r 20. Tetrahedron: x 200 to 250, y 350 to 400, z 100 to 150.
    struct {
        Vec3<double> least, greatest;
    } expected[] = {{{30, 280, 280}, {150, 400, 400}}, {{200, 350, 100}, {250, 400, 150}}};
    for (const auto& [least, greatest] : expected) {
        int found = 0;
        for (const BoxInSpace& box : all_on(levels, 1))
            // Floats near 100 are 2⁻¹⁷ apart.
            found += lies_in(least, greatest, box) && length(least - box.least) < 1e-4 &&
                     length(greatest - box.greatest) < 1e-4;
        CHECK(found == 1);
    }
    const BoxInSpace all = all_on(levels, 0).at(0);
    CHECK(length(all.least - Vec3<double>{30, 280, 100}) < 1e-4);
    CHECK(length(all.greatest - Vec3<double>{250, 400, 400}) < 1e-4);
}

TEST_CASE("a box has twelve edges, four along each axis, each once") {
    const BoxInSpace box{{0, 0, 0}, {1, 10, 100}, 0, Passage::missed, false};
    std::map<double, int> lengths;
    Vec3<double> middles{};
    for (int n = 0; n < 12; ++n) {
        const auto [from, to] = edge(box, n);
        ++lengths[length(to - from)];
        middles = middles + (from + to) / 2;
    }
    CHECK(lengths == std::map<double, int>{{1, 4}, {10, 4}, {100, 4}});
    CHECK(middles == 12.0 * Vec3<double>{0.5, 5, 50});  // the same edge twice would pull it aside
}

TEST_CASE("of many boxes a sample is drawn, in which are all that the ray meets; the counts are of all") {
    const BoxLevels levels = levels_of(crowd());
    const Vec3<double> at = levels.engine->middle();
    const RayInBoxes ray = ray_in_boxes(levels.engine, {at - Vec3<double>{100, 3, 5}, {1, .03, .05}});
    const int deepest = levels.deepest();
    const BoxesOnLevel whole = boxes_on_level(levels, deepest, &ray, levels.boxes);
    REQUIRE(whole.met > 3);
    for (const std::size_t most : std::initializer_list<std::size_t>{1, 7, 100, whole.all - 1, whole.all}) {
        CAPTURE(most);
        const BoxesOnLevel few = boxes_on_level(levels, deepest, &ray, most);
        CHECK(few.all == whole.all);
        CHECK(few.met == whole.met);
        CHECK(few.opened == whole.opened);
        const auto met = std::count_if(few.drawn.begin(), few.drawn.end(),
                                       [&](const BoxInSpace& box) { return holds(ray.met, box.code); });
        CHECK(static_cast<std::size_t>(met) == whole.met);
        CHECK(few.drawn.size() <= most + whole.met);
        CHECK(few.drawn.size() >= std::min(most, whole.all) / 2);
    }
    CHECK(whole.drawn.size() == whole.all);
}

TEST_CASE("the ray's boxes are all those above the surfaces that it meets; the search opens those above the first") {
    const Scene scene = crowd();
    const BoxLevels levels = levels_of(scene);
    const auto up = ways_up(*levels.engine);
    test::Rays random(11);
    std::vector<Ray<double>> rays;
    RayBounds reach;
    for (int i = 0; i < 200; ++i) {
        // Through the middle of a triangle, so that there is something to meet.
        const auto& corners = scene.triangles[static_cast<std::size_t>(i)].vertices;
        const Vec3<double> target = (corners[0] + corners[1] + corners[2]) / 3;
        const Vec3<double> start = target + 60.0 * random.anywhere();
        rays.push_back({start, target - start});
        reach = including(reach, rays.back());
    }
    const CertifiedSearch plain(surfaces<double>(scene, 5), {}, {}, reach, false);
    std::size_t met_in_all = 0, skipped = 0;
    for (const Ray<double>& ray : rays) {
        MetSurfaces met;
        const std::optional<ProvenHit> first = plain.trace_proven(ray, met);
        const RayInBoxes boxes = ray_in_boxes(levels.engine, ray);
        REQUIRE(boxes.walks);
        CHECK(boxes.surface == (first ? std::optional(first->surface) : std::nullopt));
        std::size_t passed_over = 0;
        for (const std::uint32_t surface : met.numbers)
            for (const std::uint32_t code : up.at(surface)) passed_over += !holds(boxes.met, code);
        CHECK(passed_over == 0);
        if (first)
            for (const std::uint32_t code : up.at(static_cast<std::uint32_t>(first->surface)))
                passed_over += !holds(boxes.opened, code);
        CHECK(passed_over == 0);
        CHECK(std::includes(boxes.met.begin(), boxes.met.end(), boxes.opened.begin(), boxes.opened.end()));
        met_in_all += met.numbers.size();
        skipped += boxes.met.size() - boxes.opened.size();
        // Level by level the same boxes, none of them twice.
        std::size_t leaves_met = 0;
        for (const std::uint32_t code : boxes.met) leaves_met += Child::is_leaf(code);
        CHECK(boxes_on_level(levels, levels.deepest(), &boxes).met == leaves_met);
    }
    CHECK(met_in_all > rays.size());
    CHECK(skipped > rays.size());  // behind the first hit, boxes are not opened
}

TEST_CASE("the nodes opened are those that `measure --what nodes` counts") {
    const Scene scene = resized(read_scene(scenes / "room.toml"), 24, 18);
    const BoxLevels levels = levels_of(scene);
    Options options;
    options.engine = EngineChoice::fast;
    const Measurement* const nodes = find_measurement("nodes");
    const Channel plane = measure(scene, options, std::span(&nodes, 1), Job{}).front().front();
    double most = 0;
    for (int y = 0; y < scene.height; ++y)
        for (int x = 0; x < scene.width; ++x) {
            const RayInBoxes ray = ray_in_boxes(levels.engine, pixel_ray(view(scene, options), x, y, scene.height));
            const auto opened = std::count_if(ray.opened.begin(), ray.opened.end(),
                                              [](std::uint32_t code) { return !Child::is_leaf(code); });
            CHECK(static_cast<double>(opened) == plane.at({x, y}));
            most = std::max(most, static_cast<double>(opened));
        }
    CHECK(most > 3);
}

TEST_CASE("in words: the paper's scene") {
    Shown shown(read_scene(scenes / "levental-2014.toml"));
    CHECK(shown.words(1).boxes == "2 boxes");
    CHECK(shown.words(1).met == "");
    CHECK(shown.words(1).whole == "Pin a pixel: which boxes does its ray meet?");
    // The green sphere's middle; its box holds both spheres, and the tetrahedron's box lies below.
    shown.pin(350, 149);
    CHECK(shown.words(1).met == "the pinned ray meets 1");
    CHECK(shown.words(1).opened == "and it is opened");
    CHECK(shown.words(1).whole == "On all levels 2 of 3 boxes opened, 2 of 6 surfaces tested.");
    CHECK(shown.words(0).boxes == "1 box");
    REQUIRE(shown.boxes.shown());
    CHECK(shown.boxes.shown()->drawn.at(0).passage == Passage::opened);
    // A corner of the picture: no box.
    shown.pin(10, 10);
    CHECK(shown.words(1).met == "the pinned ray meets none");
    CHECK(shown.words(1).opened == "");
    // The search does not test the root's box, but those in it; the ray misses all three.
    CHECK(shown.words(1).whole == "On all levels 1 of 3 boxes opened, 0 of 6 surfaces tested.");
    CHECK(shown.words(0).met == "the pinned ray meets none");
    CHECK(shown.words(0).opened == "but it is opened, untested: the boxes in it are tested at once");
    // Between the spheres and the tetrahedron, at y = 300, z = 200: in the box around all, and in none of the two.
    shown.pin(300, 299);
    CHECK(shown.words(0).met == "the pinned ray meets 1");
    CHECK(shown.words(1).met == "the pinned ray meets none");
    // There is no level 7: the deepest is drawn.
    CHECK(shown.words(7).boxes == "2 boxes");
    CHECK(shown_level(shown.state, shown.results) == 1);
}

TEST_CASE("in words: a box behind the first hit is met, and not opened") {
    Shown shown(two_clusters());
    shown.pin(250, 499 - 250);
    CHECK(shown.words(1).boxes == "2 boxes");
    CHECK(shown.words(1).met == "the pinned ray meets 2");
    CHECK(shown.words(1).opened == "1 opened; the other begins behind its first hit");
    CHECK(shown.words(1).whole == "On all levels 2 of 3 boxes opened, 8 of 16 surfaces tested.");
    // Plain doubles take the plain loop.
    Setup setup = shown.state.setup.now();
    setup.options.scalar = Scalar::double_;
    shown.state.setup.change(setup);
    CHECK(shown.words(1).whole.ends_with("drawn without boxes: its scalar or rule has only the plain loop."));
}

TEST_CASE("in words: where there are no boxes") {
    Shown nothing(two_clusters(), 1);  // the first stage knows no surfaces
    CHECK(nothing.words(0).boxes == "no boxes: there are no surfaces");
    CHECK_FALSE(nothing.boxes.shown());
    Scene scene;
    scene.spheres = {{{0, 0, 0}, 1e305, {}}};
    Shown large(scene);
    CHECK(large.words(0).boxes == "no boxes: the one surface is too large for one, and always tested");
    scene.spheres.push_back({{0, 0, 0}, 1, {}});
    Shown both(scene);
    both.pin(0, 0);
    CHECK(both.words(0).boxes == "1 box");
    CHECK(both.words(0).whole.ends_with(" 1 surface is too large for a box, and always tested."));
}

TEST_CASE("a ray whose numbers are not fit for boxes is said to be tested against all") {
    Scene scene = two_clusters();
    scene.view = ParallelView{{1e300, 0, 0}, {0, 1, 0}, {0, 0, 1}, {-1, 0, 0}};
    Shown shown(scene);
    shown.pin(250, 249);
    CHECK(shown.words(1).met == "");
    CHECK(shown.words(1).whole == "The pinned ray's numbers are not fit for boxes: it is tested against all surfaces.");
}

TEST_CASE("the key b: from off to level 0, deeper until the deepest; with Shift back, and off") {
    Shown shown(read_scene(scenes / "room.toml"));
    const int deepest = shown.results.boxes->deepest();
    REQUIRE(deepest >= 2);
    shown.state.space_shown = false;
    const auto press = [&](bool shift) { obey({Key::character, 'b', false, shift}, shown.state, shown.results); };
    press(true);
    CHECK_FALSE(shown.state.box_level);
    press(false);
    CHECK(shown.state.box_level == 0);
    CHECK(shown.state.space_shown);  // they are drawn there
    for (int i = 0; i < deepest + 3; ++i) press(false);
    CHECK(shown.state.box_level == deepest);
    press(true);
    CHECK(shown.state.box_level == deepest - 1);
    // From a level that there is not, back from the one that is drawn.
    shown.state.box_level = engine::most_levels;
    press(true);
    CHECK(shown.state.box_level == deepest - 1);
    for (int i = 0; i < deepest; ++i) press(true);
    CHECK_FALSE(shown.state.box_level);
    // Undo does not concern them.
    CHECK_FALSE(shown.state.setup.can_undo());
}

TEST_CASE("boxes are made when they are shown, and let go when they are not; another scene keeps the level") {
    HiddenViewer viewer(opened(scenes / "levental-2014.toml"), {640, 400});
    viewer.settle();
    CHECK_FALSE(viewer.results().boxes);
    viewer.state().box_level = 1;
    viewer.settle();
    REQUIRE(viewer.results().boxes);
    CHECK(viewer.results().boxes->engine->size() == 6);
    open(viewer.state(), scenes / "sphere.toml");
    CHECK(viewer.state().box_level == 1);
    viewer.settle();
    REQUIRE(viewer.results().boxes);
    CHECK(viewer.results().boxes->engine->size() == 1);
    // Turns and light do not change them; a stage may.
    const auto before = viewer.results().boxes;
    viewer.state().setup.change(turned(viewer.state().setup.now(), Axis::z, 10));
    viewer.settle();
    CHECK(viewer.results().boxes == before);
    Setup setup = viewer.state().setup.now();
    setup.options.stage = 1;
    viewer.state().setup.change(setup);
    viewer.settle();
    REQUIRE(viewer.results().boxes);
    CHECK(viewer.results().boxes->engine->size() == 0);
    viewer.state().box_level.reset();
    viewer.settle();
    CHECK_FALSE(viewer.results().boxes);
    CHECK(viewer.screen().complaints() == 0);
}

TEST_CASE("the button lies on the space view: a click on it shows boxes, and does not turn the view") {
    HiddenViewer viewer(opened(scenes / "levental-2014.toml"), {640, 400});
    viewer.settle();
    const Orbit before = viewer.state().orbit;
    const auto drag = [&](float x, float y, float to) {
        viewer.state().orbit = before;
        viewer.frame({.x = x, .y = y});
        viewer.frame({.x = x, .y = y, .left = true});
        viewer.frame({.x = to, .y = y, .left = true});
        viewer.frame({.x = to, .y = y});
    };
    // The space view is the window's lower part; its upper left corner, where the button is, lies below the middle.
    float y = 200;
    while (y < 380 && !viewer.state().box_level) drag(30, y += 5, 32);
    REQUIRE(viewer.state().box_level == 0);
    CHECK(viewer.state().orbit == before);
    drag(150, y + 60, 170);  // beside the button
    CHECK_FALSE(viewer.state().orbit == before);
}

TEST_CASE("scripts show boxes, and say what is wrong with a level") {
    const test::Folder folder;
    const auto drawn = [&](const std::string& name, const std::string& commands) {
        const std::string picture = name + ".png";
        test::write(folder / (name + ".script"), "open " + (scenes / "levental-2014.toml").string() +
                                                     "\nsize 500x400\n" + commands + "\nscreenshot " + picture + "\n");
        const test::Ran ran = test::run_glassbox({"view", "--script", name + ".script"}, {.folder = folder.path});
        CAPTURE(ran.err);
        REQUIRE(ran.status == 0);
        return test::content(folder / picture);
    };
    const std::string without = drawn("without", ""), level_1 = drawn("one", "boxes 1");
    CHECK(level_1 != without);
    CHECK(drawn("zero", "boxes 0") != level_1);
    CHECK(drawn("keys", "key b\nkey b") == level_1);
    CHECK(drawn("off", "boxes 1\nboxes off") == without);
    test::write(folder / "bad.script", "boxes deep\n");
    test::check_refused(folder, {"view", "--script", "bad.script"}, 1, {"bad.script:1:1: error: ", "boxes", "deep"});
}
