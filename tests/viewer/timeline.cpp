// The timeline of a pixel, against numbers worked out by hand on the paper's scene. Column j and row i are pixel (j,
// 499 − i), whose ray starts at (500, j, i) and runs along (−1, 0, 0).
#include "explain/timeline.hpp"

#include <doctest.h>

#include <algorithm>
#include <string>

#include "../explain/far_sphere.hpp"
#include "explain/explain.hpp"
#include "explain/loss.hpp"
#include "scene/scene_file.hpp"
#include "viewer/model/state/playing.hpp"
#include "viewer/model/story/lesson.hpp"
#include "viewer/model/work/watching.hpp"

using namespace glassbox;

namespace {

Scene paper() { return read_scene(SCENES "/levental-2014.toml"); }

Story tell(int column, int row, const Options& options = {}) { return explain(paper(), options, column, 499 - row); }

/// The first event from `from` on whose formula begins so; the end if there is none.
std::size_t find_formula(const std::vector<Event>& events, const std::string& begin, std::size_t from = 0) {
    std::size_t i = from;
    while (i < events.size() && !events[i].formula.starts_with(begin)) ++i;
    return i;
}

std::ptrdiff_t count_formulas(const std::vector<Event>& events, const std::string& begin) {
    return std::count_if(events.begin(), events.end(), [&](const Event& e) { return e.formula.starts_with(begin); });
}

double value(const Story& story, const Event& event) {
    return tape_of(story, event.place.value())[event.place->step].checked.value;
}

}  // namespace

// P = (500, 350, 350), and P − centre = (400, 0, 0): Δ = 1·(50² − 0²) = 2500 by the stable rule, which has l = 0, the
// line going through the centre; b = 400, q = 400 + √2500 = 450, c = 400² − 50² = 157500, t₀ = c/q = 350. The second
// sphere's centre is (50, 300, 300), so l² = 50² + 50² = 5000 and Δ = 20² − 5000 = −4600.
TEST_CASE("the middle of the green sphere") {
    const Story story = tell(350, 350);
    const std::vector<Event> events = timeline(story);
    CHECK(events[0].group == "the ray");
    CHECK(events[1].what == "surface 0, sphere, is tested");

    const std::size_t first = find_formula(events, "Δ = ");
    REQUIRE(first < events.size());
    CHECK(value(story, events[first]) == 2500);
    const std::size_t asked = find_formula(events, "Δ ≥ 0", first);
    REQUIRE(asked < events.size());
    CHECK(events[asked].what == "2500 ≥ 0");
    CHECK(events[asked].holds == true);
    const std::size_t root = find_formula(events, "t₀ = ", asked);
    REQUIRE(root < events.size());
    CHECK(events[root].what == "350 = 157500 ÷ 450");
    const std::size_t ahead = find_formula(events, "t₀ > 0", root);
    REQUIRE(ahead + 3 < events.size());
    CHECK(events[ahead + 1].formula == "t₀ > 0");  // computed for the choice of the root, and for the verdict
    CHECK(events[ahead + 2].what == "surface 0: met at t = 350");
    CHECK(events[ahead + 2].holds == true);
    CHECK(events[ahead + 3].what == "surface 1, sphere, is tested");

    const std::size_t second = find_formula(events, "Δ = ", ahead);
    REQUIRE(second < events.size());
    CHECK(value(story, events[second]) == -4600);
    CHECK(count_formulas(events, "Δ = ") == 2);

    // The hit's point is computed for itself and again for the normal: listed once.
    CHECK(count_formulas(events, "point.x = ") == 1);
    const std::size_t point = find_formula(events, "point.x = ", second);
    REQUIRE(point < events.size());
    CHECK(value(story, events[point]) == 150);
    const std::size_t n_l = find_formula(events, "n·l = ", point);
    REQUIRE(n_l < events.size());
    CHECK(events[n_l].group == "the light");
    CHECK(events.back().what == "the ray brings (72, 255, 41)");
}

// P = (500, 370, 110) looks at PSR, surface 4: seen from there A = (−300, −20, −10), B = (−250, 5, −10), C = (−300, 5,
// 40). With D = (−1, 0, 0) a side product is minus the cross product's x: a = −(C × B)ₓ = −(5·(−10) − 40·5) = 250,
// b = −(A × C)ₓ = −(−20·40 + 10·5) = 750, c = −(B × A)ₓ = −(5·(−10) − 10·20) = 250. Their sum is twice the area seen,
// 25·50 = 1250, and t = (250·300 + 750·250 + 250·300) / 1250 = 270. PQR, in the plane x = 200, is met behind it.
TEST_CASE("a face of the tetrahedron") {
    const Story story = tell(370, 110);
    const std::vector<Event> events = timeline(story);
    const auto tested = std::find_if(events.begin(), events.end(),
                                     [](const Event& e) { return e.what == "surface 4, triangle, is tested"; });
    REQUIRE(tested != events.end());
    const auto from = static_cast<std::size_t>(tested - events.begin());
    const std::size_t a = find_formula(events, "a = ", from), b = find_formula(events, "b = ", from),
                      c = find_formula(events, "c = ", from);
    REQUIRE(std::max({a, b, c}) < events.size());
    CHECK(events[a].formula == "a = D·((C − P) × (B − P))");
    CHECK(events[b].formula == "b = D·((A − P) × (C − P))");
    CHECK(value(story, events[a]) == 250);
    CHECK(value(story, events[b]) == 750);
    CHECK(value(story, events[c]) == 250);
    CHECK(lesson_of(story, events[a]).name == "side");
    CHECK(lesson_of(story, events[a]).text.find("D·(B × A)") != std::string::npos);
    const std::size_t ahead = find_formula(events, "t > 0", from);
    REQUIRE(ahead + 1 < events.size());
    CHECK(events[ahead].what == "270 > 0");
    CHECK(events[ahead + 1].what == "surface 4: met at t = 270");
    const auto nearest = std::find_if(events.begin(), events.end(),
                                      [](const Event& e) { return e.what.starts_with("nearest of 2 met: surface 4"); });
    CHECK(nearest != events.end());

    // The first condition not to hold is the green sphere's: l² = 20² + 240² = 58000, Δ = 2500 − 58000. Then its
    // verdict. Nothing has failed: both are true.
    const std::size_t no = stepped(events, 0, StepTo::next_no);
    CHECK(events[no].what == "−55500 ≥ 0");
    CHECK(stepped(events, no, StepTo::next_no) == no + 1);
    CHECK(events[no + 1].what.starts_with("surface 0: missed"));
    CHECK(stepped(events, 0, StepTo::next_failed) == 0);
}

// (v·D)² = v² = 10¹⁴ in float, so that Δ = 0 ≥ 0 holds; truly v² has 60² more, and Δ = 50² − 60² < 0.
TEST_CASE("a condition fails where its answer is not the true one") {
    const std::vector<Event> events = timeline(story_of_far_sphere(410));
    const std::size_t failed = stepped(events, 0, StepTo::next_failed);
    REQUIRE(failed > 0);
    CHECK(events[failed].formula == "Δ ≥ 0");
    CHECK(events[failed].holds == true);
    CHECK(events[failed].failed);
}

// The same ray misses the sphere truly, so its test's answer fails, and that it is the nearest. 350 is truly met.
TEST_CASE("a surface's answer fails where it is not the true one, and so does what is nearest") {
    const auto answers = [](int column) {
        std::vector<Event> found;
        for (Event& event : timeline(story_of_far_sphere(column)))
            if (event.what.starts_with("surface 0: ") || event.what.starts_with("nearest of "))
                found.push_back(std::move(event));
        return found;
    };
    const std::vector<Event> wrong = answers(410), right = answers(350);
    REQUIRE(wrong.size() == 2);
    REQUIRE(right.size() == 2);
    CHECK(wrong[0].holds == true);
    for (const Event& event : wrong) CHECK(event.failed);
    CHECK(right[0].holds == true);
    for (const Event& event : right) CHECK_FALSE(event.failed);
}

TEST_CASE("operands come before results, and of a line left ones before right ones") {
    Options by_textbook;
    by_textbook.sphere_rule = Textbook{};
    for (const Story& story : {tell(370, 110), tell(350, 350, by_textbook)}) {
        const std::vector<Event> events = timeline(story);
        int both = 0;
        for (std::size_t i = 0; i < events.size(); ++i) {
            const auto &left = events[i].left_made_by, &right = events[i].right_made_by;
            if (left) CHECK(*left < i);
            if (right) CHECK(*right < i);
            if (!left || !right) continue;
            const auto step = [&](std::size_t event) {
                return tape_of(story, *events[event].place)[events[event].place->step].step;
            };
            const Step a = step(*left), b = step(*right), result = step(i);
            if (a.line != result.line || b.line != result.line || a.call != result.call || b.call != result.call)
                continue;
            CAPTURE(events[i].formula);
            CAPTURE(events[*left].formula);
            CAPTURE(events[*right].formula);
            CHECK(*left < *right);
            ++both;
        }
        CHECK(both > 20);  // each dot product has two such sums
    }
}

// A dot product is read x, y, their sum, z, the sum of all.
TEST_CASE("a dot product in reading order") {
    const Story story = tell(350, 350);
    const std::vector<Event> events = timeline(story);
    const std::size_t last = find_formula(events, "n·l = ");
    REQUIRE(last < events.size());
    REQUIRE(last >= 4);
    CHECK(events[last - 4].formula == "n.x × l.x");
    CHECK(events[last - 3].formula == "n.y × l.y");
    CHECK(events[last - 1].formula == "n.z × l.z");
    CHECK(events[last - 2].left_made_by == last - 4);
    CHECK(events[last - 2].right_made_by == last - 3);
    CHECK(events[last].left_made_by == last - 2);
    CHECK(events[last].right_made_by == last - 1);
}

TEST_CASE("what feeds a number: the steps of its operands, and theirs, wherever they were done") {
    const Story story = tell(350, 350);
    const std::vector<Event> events = timeline(story);
    const std::size_t n_l = find_formula(events, "n·l = "), t0 = find_formula(events, "t₀ = "),
                      half = find_formula(events, "n·h = ");
    REQUIRE(std::max({n_l, t0, half}) < events.size());
    const std::vector<bool> feeds = feeding(events, n_l);
    CHECK(feeds[n_l]);
    CHECK(feeds[t0]);  // on the tape of the surface's test: the normal is found from the point, and that from t₀
    CHECK_FALSE(feeds[half]);
    for (std::size_t i = 0; i < events.size(); ++i) {
        if (!feeds[i]) continue;
        CHECK(events[i].place.has_value());
        CHECK(events[i].surface.value_or(0) == 0);
        if (i == n_l) continue;
        const bool used = std::ranges::any_of(events, [&](const Event& later) {
            return feeds[static_cast<std::size_t>(&later - events.data())] &&
                   (later.left_made_by == i || later.right_made_by == i);
        });
        CHECK(used);
    }
    CHECK(stepped(events, n_l, StepTo::first, feeds) ==
          static_cast<std::size_t>(std::ranges::find(feeds, true) - feeds.begin()));
    CHECK(stepped(events, 0, StepTo::last, feeds) == n_l);
    CHECK(feeding(events, 0) == [&] {
        std::vector<bool> only(events.size(), false);
        only[0] = true;
        return only;
    }());
}

TEST_CASE("the next cancellation is where the textbook's discriminant loses all") {
    const Story story = story_of_far_sphere(350);
    const std::vector<Event> events = timeline(story);
    const std::size_t found = stepped(events, 0, StepTo::next_cancellation);
    CHECK(events[found].formula == "Δ = ((P − centre)·D)² − D² ((P − centre)² − radius²)");
    CHECK(value(story, events[found]) == 0);
    for (const Event& event : events) {
        if (!event.place) continue;
        const auto tape = tape_of(story, *event.place);
        CHECK(event.cancellation == is_cancellation(tape, tape[event.place->step]));
    }
}

TEST_CASE("forward and back again is where it was; the ends stay") {
    const std::vector<Event> events = timeline(tell(370, 110));
    REQUIRE(events.size() > 100);
    for (std::size_t i = 0; i + 1 < events.size(); ++i) {
        CHECK(stepped(events, i, StepTo::forward) == i + 1);
        CHECK(stepped(events, i + 1, StepTo::back) == i);
    }
    CHECK(stepped(events, 0, StepTo::back) == 0);
    CHECK(stepped(events, 0, StepTo::last) == events.size() - 1);
    CHECK(stepped(events, events.size() - 1, StepTo::forward) == events.size() - 1);
    CHECK(stepped(events, 7, StepTo::first) == 0);
    CHECK(stepped({}, 3, StepTo::forward) == 0);
}

TEST_CASE("each step has its line of the core's source, an operation, and its formula is described") {
    const auto has_operation = [](std::string_view line) {
        for (const std::string_view sign : {"+", "-", "*", "/", "<", ">", "==", "!=", "sqrt(", "abs(", "pow("})
            if (line.find(sign) != std::string_view::npos) return true;
        return false;
    };
    const auto check = [&](const Story& story) {
        for (const Event& event : timeline(story)) {
            if (!event.place) continue;
            CAPTURE(event.what);
            CAPTURE(event.formula);
            const Step& step = tape_of(story, *event.place)[event.place->step].step;
            if (step.operation == Operation::round) continue;  // done by no line: the scene's number is read
            const SourceLine source = source_of(story, event);
            REQUIRE(source.file);
            const auto text = lines(*source.file);
            REQUIRE(source.line >= 1);
            REQUIRE(source.line <= text.size());
            CAPTURE(text[source.line - 1]);
            CHECK(has_operation(text[source.line - 1].substr(0, text[source.line - 1].find("//"))));
            CHECK_FALSE(lesson_of(story, event).text.empty());
        }
    };
    for (const TriangleRule& rule :
         {TriangleRule(Pluecker{}), TriangleRule(Tolerance{}), TriangleRule(MoellerTrumbore{})})
        for (const int row : {110, 350}) {
            Options options;
            options.triangle_rule = rule;
            if (row == 350) options.sphere_rule = Textbook{};
            check(tell(row == 350 ? 350 : 370, row, options));
        }
    Options published;
    published.sphere_rule = Levental2014{};
    check(tell(350, 350, published));
    check(tell(400, 350, published));
    Options stage1;
    stage1.stage = 1;
    check(tell(350, 350, stage1));
    Scene phong = paper();
    phong.shading.model = ShadingModel::phong;
    check(explain(phong, {}, 350, 149));
}

TEST_CASE("playing goes on by its speed, and stops at the end") {
    ViewerState state;
    Results results;
    results.timeline = timeline(tell(350, 350));
    play_or_pause(state, results);
    CHECK(state.playing);
    state.steps_per_second = 4;
    go_on_playing(state, results, .5);  // two steps
    CHECK(state.step == 2);
    go_on_playing(state, results, .125);  // and a half: not yet another
    CHECK(state.step == 2);
    go_on_playing(state, results, .125);
    CHECK(state.step == 3);
    go_on_playing(state, results, 1e6);
    CHECK(state.step == results.timeline.size() - 1);
    CHECK_FALSE(state.playing);
    play_or_pause(state, results);  // after the end it starts again
    CHECK(state.step == 0);
}

// The paper's loops: columns from the left, in each the rows from the bottom.
TEST_CASE("the loops that are watched") {
    CHECK(loop_place(0, 500).column == 0);
    CHECK(loop_place(499, 500).row == 499);
    CHECK(loop_place(500, 500).column == 1);
    CHECK(loop_place(500, 500).row == 0);
    ViewerState state;
    state.scene = std::make_shared<const Scene>(paper());
    watch(state);
    state.watching.pixels_per_second = 1000;
    go_on_watching(state, 2);
    CHECK(state.watching.shown == 2000);
    state.watching.running = false;
    go_on_watching(state, 2);
    CHECK(state.watching.shown == 2000);
    state.watching.running = true;
    go_on_watching(state, 1000);  // 250000 pixels are all
    CHECK_FALSE(state.watching.on);
}
