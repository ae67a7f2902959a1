// What can be asked of a pixel, and what counts as right, on the paper's scene. Column j and row i are pixel (j, 499 −
// i), whose ray starts at (500, j, i) and runs along (−1, 0, 0).
#include "explain/questions.hpp"

#include <doctest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "explain/explain.hpp"
#include "explain/predict.hpp"
#include "far_sphere.hpp"
#include "scene/scene_file.hpp"

using namespace glassbox;

namespace {

Scene paper() { return read_scene(SCENES "/levental-2014.toml"); }

/// A pixel's story, its timeline and what is asked of it.
struct Told {
    Story story;
    std::vector<Event> events = timeline(story);
    std::vector<Question> all = questions(story, events);

    std::string judged(std::size_t question, double said) const {
        return glassbox::judged(story, events, all[question], said);
    }
};

Told tell(int column, int row) { return {explain(paper(), {}, column, 499 - row)}; }

Told tell_far(int column) { return {story_of_far_sphere(column)}; }

const Question* find(const Told& told, Asked asked, const std::string& formula) {
    for (const Question& question : told.all)
        if (question.asked == asked && told.events[question.answer].formula.starts_with(formula)) return &question;
    return nullptr;
}

}  // namespace

// Surface 0 is met: Δ = 50² − 0² = 2500 and t₀ = 350. Surface 1, about (50, 300, 300) with r = 20, is not: Δ = 400 −
// 5000. PQR, surface 2, is seen from (500, 350, 350) as A = (−300, 0, −250), B = (−300, 50, −250), C = (−300, 25,
// −200), so that a = −(C × B)ₓ = 6250 − 10000 < 0, b = −(A × C)ₓ = −250·25 < 0, c = −(B × A)ₓ = 50·250 > 0: the line
// passes outside.
TEST_CASE("each surface is asked about before its test, and then each number whose sign decides") {
    const Told told = tell(350, 350);
    struct Expected {
        Asked asked;
        std::string begins;
        double right;
    };
    const Expected expected[] = {
        {Asked::hit, "surface 0, sphere about (100, 350, 350), radius 50: hit or miss?", 1},
        {Asked::sign, "Δ: which sign?", 1},  // l², too long to be written, would stand there as its value
        {Asked::sign, "t₀ = ", 1},
        {Asked::hit, "surface 1, sphere about (50, 300, 300), radius 20: hit or miss?", 0},
        {Asked::sign, "Δ: which sign?", -1},
        {Asked::hit, "surface 2, triangle A = (200, 350, 100), B = (200, 400, 100), C = (200, 375, 150): hit or", 0},
        {Asked::sign, "a = D·((C − P) × (B − P)): which sign?", -1},
        {Asked::sign, "b = ", -1},
        {Asked::sign, "c = ", 1},
        {Asked::hit, "surface 3", 0},
    };
    REQUIRE(told.all.size() > std::size(expected));
    for (std::size_t i = 0; i < std::size(expected); ++i) {
        CAPTURE(i);
        CHECK(told.all[i].asked == expected[i].asked);
        CHECK(in_words(told.story, told.events, told.all[i]).starts_with(expected[i].begins));
        CHECK(told.all[i].right == expected[i].right);
    }
    CHECK(told.events[told.all[0].at].what == "surface 0, sphere, is tested");
    CHECK(told.all[1].at == told.all[0].at);  // before any of the test's numbers is there
    CHECK(told.events[told.all[0].answer].what == "surface 0: met at t = 350");
    CHECK(find(told, Asked::sign, "n·l"));  // is the light before the surface or behind it?
    for (std::size_t i = 0; i < told.all.size(); ++i) {
        CHECK(told.all[i].at <= told.all[i].answer);
        if (i > 0) CHECK(told.all[i - 1].at <= told.all[i].at);
    }
}

// In float v² = 10¹⁴ + d² is a multiple of 2²³, as (v·D)² is: Δ = 0 for the ray through the middle, d = 0, and for the
// one that passes at d = 60. Truly Δ = 2500 and 2500 − 3600. All 24 bits of it are lost, no sign is right, and the
// second ray is said to hit what it misses.
TEST_CASE("nothing is asked that rounding has changed; how much it has changed is") {
    for (const int column : {350, 410}) {
        CAPTURE(column);
        const Told told = tell_far(column);
        CHECK(find(told, Asked::sign, "Δ = ") == nullptr);
        const Question* const bits = find(told, Asked::bits, "Δ = ");
        REQUIRE(bits);
        CHECK(bits->right == 24);
        CHECK(bits->at == bits->answer);
        CHECK(is_right(*bits, 23));
        CHECK(is_right(*bits, 25));
        CHECK_FALSE(is_right(*bits, 22.9));
        CHECK(judged(told.story, told.events, *bits, 3) == "wrong: 24.0 bits lost; 1 more or less counts as right");
        const bool asks_verdict =
            std::any_of(told.all.begin(), told.all.end(), [](const Question& q) { return q.asked == Asked::hit; });
        CHECK(asks_verdict == (column == 350));
    }
}

TEST_CASE("a number that is not finite is no question") {
    Scene scene = paper();
    scene.triangles.clear();
    scene.spheres = {{{-1e30, 350, 350}, 50, {0, 255, 0}}};  // v² = 10⁶⁰, far beyond a float
    Options options;
    options.scalar = Scalar::float_;
    options.sphere_rule = Textbook{};
    const Told told{explain(scene, options, 350, 149)};
    for (const Question& question : told.all) CHECK(question.asked != Asked::hit);
    CHECK(find(told, Asked::sign, "Δ = ") == nullptr);
    CHECK(find(told, Asked::bits, "Δ = ") == nullptr);
}

TEST_CASE("answers as they are typed") {
    CHECK(answer_in("h", Asked::hit) == 1);
    CHECK(answer_in("miss", Asked::hit) == 0);
    CHECK(answer_in("+", Asked::hit) == std::nullopt);
    CHECK(answer_in("+", Asked::sign) == 1);
    CHECK(answer_in("−", Asked::sign) == -1);  // the minus sign that we print
    CHECK(answer_in("-", Asked::sign) == -1);
    CHECK(answer_in("0", Asked::sign) == 0);
    CHECK(answer_in("1", Asked::sign) == std::nullopt);
    CHECK(answer_in("26.5", Asked::bits) == 26.5);
    for (const char* typed : {"-1", "nan", "inf", "2 bits", ""}) CHECK(answer_in(typed, Asked::bits) == std::nullopt);
}

TEST_CASE("a verdict is settled when its test is over, and nothing behind the next question is seen") {
    const Told told = tell(350, 350);
    const auto seen = [&](std::size_t answered) { return events_seen(told.events, told.all, answered); };
    CHECK(seen(0) == 2);  // the ray, and that surface 0 is tested
    Answers answers{1};
    CHECK(seen(1) == 2);
    CHECK(score(told.events, told.all, answers) == Score{0, 0});
    CHECK(just_settled(told.events, told.all, answers).empty());
    answers.push_back(-1);  // Δ is positive
    CHECK(score(told.events, told.all, answers) == Score{0, 1});
    CHECK(just_settled(told.events, told.all, answers) == std::vector<std::size_t>{1});
    CHECK(told.judged(1, -1) == "wrong: Δ = 2500");
    answers.push_back(1);
    CHECK(score(told.events, told.all, answers) == Score{2, 3});
    CHECK(just_settled(told.events, told.all, answers) == std::vector<std::size_t>{2, 0});
    CHECK(told.judged(0, 1) == "right: met, nearest: t = 350: Δ = 2500, t₀ = 350");
    answers.emplace_back();  // surface 1 is skipped
    answers.push_back(-1);
    CHECK(score(told.events, told.all, answers) == Score{3, 4});
    CHECK(seen(told.all.size()) == told.events.size());
}

TEST_CASE("a reader at the terminal") {
    std::string out;
    std::vector<std::string> lines{"h", "what?", " - ", "+", "", "q", "h"};
    std::size_t next = 0;
    const auto read = [&]() -> std::optional<std::string> { return lines[next++] + '\r'; };
    const Story story = tell(350, 350).story;
    predict(
        story, [&](std::string_view text) { out += text; }, read);
    CHECK(next == 6);
    for (const char* part : {"radius 50: hit or miss? (h or m) ", "  +, - or 0, Enter to skip, q to end: ",
                             "  wrong: Δ = 2500\n", "  right: t₀ = 350\n", "  right: met, nearest: t = 350"})
        CHECK_MESSAGE(out.find(part) != std::string::npos, part);
    CHECK(out.ends_with("\n2 of 3 right\n"));

    out.clear();
    predict(
        story, [&](std::string_view text) { out += text; }, [] { return std::nullopt; });
    CHECK(out.ends_with("\nnothing predicted yet\n"));
    Options stage1;
    stage1.stage = 1;
    out.clear();
    predict(
        explain(paper(), stage1, 350, 149), [&](std::string_view text) { out += text; }, [] { return std::nullopt; });
    CHECK(out.find("Nothing is decided here") != std::string::npos);
}
