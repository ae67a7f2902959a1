// The steps as a debugger's: call stacks, into, over and out, operands, what feeds a number, the worst losses.
#include "viewer/model/story/stepping.hpp"

#include <doctest.h>

#include <algorithm>

#include "../explain/far_sphere.hpp"
#include "explain/loss.hpp"
#include "explain/words.hpp"
#include "viewer/model/state/keys.hpp"
#include "viewer/model/story/code.hpp"
#include "viewer/model/story/cursor.hpp"
#include "viewer/model/story/functions.hpp"
#include "viewer/model/story/predicting.hpp"

using namespace glassbox;

namespace {

Story tell(int column, int row, const Options& options = {}) {
    return explain(read_scene(SCENES "/levental-2014.toml"), options, column, 499 - row);
}

Options by_textbook() {
    Options options;
    options.sphere_rule = Textbook{};
    return options;
}

/// A pinned pixel's steps, as the background shows them.
struct Pinned {
    ViewerState state;
    Results results;

    explicit Pinned(Story story) {
        state.page = Page::steps;
        results.story = std::make_shared<const Story>(std::move(story));
        results.timeline = timeline(*results.story);
        results.questions = questions(*results.story, results.timeline);
        follow_steps(state, results);
    }
    void press(char32_t character, bool shift = false) {
        obey({Key::character, character, false, shift}, state, results);
        follow_steps(state, results);
    }
    const Event& now() const { return results.timeline[state.step]; }
    std::vector<StackLine> stack() const { return call_stack(*results.story, now()); }
    /// The line that is looked at.
    std::string_view code() const { return code_of(stack()[level_now(state, results)]); }
    std::size_t find(const std::string& formula) const {
        std::size_t i = 0;
        while (i < results.timeline.size() && !results.timeline[i].formula.starts_with(formula)) ++i;
        REQUIRE(i < results.timeline.size());
        return i;
    }
};

}  // namespace

TEST_CASE("a call stack begins with the lesson's line and ends with the operation's") {
    Pinned pinned(tell(350, 350, by_textbook()));
    pinned.state.step = pinned.find("Δ = ");
    const std::vector<StackLine> stack = pinned.stack();
    REQUIRE(stack.size() == 3);
    CHECK(stack[0].function == "intersect");
    CHECK(code_of(stack[0]) == "const auto [real, t0, t1] = rule(ray, sphere, probe);");
    CHECK(stack[1].function == "Textbook");
    CHECK(code_of(stack[1]) == "const Real delta = discriminant(equation);");
    CHECK(stack[2].function == "discriminant");
    CHECK(code_of(stack[2]) == "return b * b - a * c;");
}

TEST_CASE("a rule that asks another one, or a function of its own, has it in the call stack") {
    Options by_paper;
    by_paper.sphere_rule = Levental2014{};
    Pinned pinned(tell(350, 350, by_paper));
    pinned.state.step = pinned.find("Δ = ");
    std::vector<StackLine> stack = pinned.stack();
    REQUIRE(stack.size() == 4);
    CHECK(stack[1].function == "Levental2014");
    CHECK(code_of(stack[1]) == "const auto [real, t0, t1] = roots_by(Textbook{}, ray, sphere, probe);");
    CHECK(stack[2].function == "Textbook");
    CHECK(stack[3].function == "discriminant");

    Options by_tolerance;
    by_tolerance.triangle_rule = Tolerance{};
    Pinned other(tell(370, 110, by_tolerance));
    other.state.step = other.find("a+b+c = ");
    stack = other.stack();
    REQUIRE(stack.size() >= 2);
    CHECK(stack.back().function == "accepts");
    CHECK(code_of(stack.back()) == "const Real sum = s.a + s.b + s.c;");
    CHECK(code_of(stack[stack.size() - 2]).ends_with("{ return accepts(*this, s, told_to); };"));
}

TEST_CASE("the line of a vector operator is told where its function has only one, else the function alone") {
    Pinned pinned(tell(370, 110));
    pinned.state.step = pinned.find("(A − P).x");
    std::vector<StackLine> stack = pinned.stack();
    REQUIRE(stack.size() >= 2);
    CHECK(code_of(stack[stack.size() - 2]) == "return {triangle.A - P, triangle.B - P, triangle.C - P};");
    CHECK(code_of(stack.back()) == "return {a.x - b.x, a.y - b.y, a.z - b.z};");
    Options options;
    options.triangle_rule = MoellerTrumbore{};
    Pinned other(tell(370, 110, options));
    other.state.step = other.find("B.x − A.x");  // of B − A, C − A and P − A, on three lines
    stack = other.stack();
    REQUIRE(stack.size() >= 2);
    CHECK(stack[stack.size() - 2].line == 0);
    CHECK(stack[stack.size() - 2].function == "MoellerTrumbore");
}

// The text is asked which function a line is in, the record which calls a step is done in: they must agree.
TEST_CASE("every line of every call stack is in a function that was called") {
    Options by_paper;
    by_paper.sphere_rule = Levental2014{};
    std::vector<Story> stories{tell(350, 350), tell(350, 350, by_textbook()), tell(350, 350, by_paper)};
    for (const TriangleRule& rule :
         {TriangleRule(Pluecker{}), TriangleRule(Tolerance{}), TriangleRule(MoellerTrumbore{})}) {
        Options options;
        options.triangle_rule = rule;
        stories.push_back(tell(370, 110, options));
    }
    Scene phong = read_scene(SCENES "/levental-2014.toml");
    for (const ShadingModel model : {ShadingModel::phong, ShadingModel::blinn_phong}) {
        phong.shading.model = model;
        stories.push_back(explain(phong, {}, 350, 149));
    }
    Options first;
    first.stage = 1;
    stories.push_back(tell(350, 350, first));
    std::size_t lines = 0, unknown = 0;
    for (const Story& story : stories)
        for (const Event& event : timeline(story)) {
            if (!event.place) continue;
            const std::span<const Call> calls = calls_of(story, *event.place);
            const std::vector<CallNumber> around = calls_around(story, *event.place);
            const auto was_called = [&](const std::string& name) {
                return std::ranges::any_of(around, [&](CallNumber call) { return calls[call].function == name; });
            };
            const std::vector<StackLine> stack = call_stack(story, event);
            CAPTURE(event.formula);
            for (std::size_t i = 0; i < stack.size(); ++i) {
                CAPTURE(stack[i].function);
                CAPTURE(stack[i].line);
                ++lines;
                unknown += stack[i].line == 0;
                REQUIRE(stack[i].file);
                if (i + 1 == stack.size() && stack[i].function.starts_with("operator")) continue;
                if (around.empty()) continue;
                CHECK(was_called(stack[i].function));
                if (i + 1 == stack.size()) {
                    CHECK(stack[i].function == calls[around.back()].function);
                    continue;
                }
                // A line that calls a function names it; a statement may go on beyond the line.
                const std::string& next = stack[i + 1].function;
                const bool to_own_lambda = next == stack[i].function;
                if (stack[i].line == 0 || next.starts_with("operator") || to_own_lambda) continue;
                std::string near;
                for (std::size_t line = stack[i].line - 1; line <= stack[i].line + 1; ++line)
                    near += code_of({0, "", stack[i].file, line});
                const bool calls_it =
                    near.find(next + '(') != std::string::npos || near.find("rule(") != std::string::npos ||
                    near.find(next + "{}") != std::string::npos ||  // a rule that another one asks for its roots
                    near.find("is_inside(") != std::string::npos || near.find("highlight()") != std::string::npos;
                CHECK(calls_it);
            }
        }
    CHECK(lines > 1000);
    CHECK(unknown * 20 < lines);
}

TEST_CASE("into, over and out follow the call stack") {
    Pinned pinned(tell(350, 350, by_textbook()));
    // The first step of the first surface's test: (P − centre).x, in `quadratic`.
    pinned.state.step = 2;
    CHECK(pinned.now().formula == "P.x − centre.x");
    CHECK(pinned.code() == "return {a.x - b.x, a.y - b.y, a.z - b.z};");
    pinned.press('o');  // over all three coordinates: to the line that the operator's caller goes on with
    CHECK(pinned.now().formula == "D.x × D.x");
    CHECK(pinned.code() == "return {dot(D, D), dot(v, D), dot(v, v) - r * r};");
    CHECK(pinned.stack()[2].function == "quadratic");
    pinned.press('i');
    CHECK(pinned.now().formula == "D.x × D.x");
    CHECK(pinned.code() == "return a.x * b.x + a.y * b.y + a.z * b.z;");
    pinned.press('u');  // out of dot: to the next of the three numbers on that line
    CHECK(pinned.now().formula == "(P − centre).x × D.x");
    CHECK(pinned.code() == "return {dot(D, D), dot(v, D), dot(v, v) - r * r};");
    pinned.press('o');
    CHECK(pinned.code() == "const Real delta = discriminant(equation);");
    CHECK(level_now(pinned.state, pinned.results) == 1);
    const std::size_t there = pinned.state.step;
    pinned.press('i');  // looks into discriminant, where the step already is
    CHECK(pinned.state.step == there);
    CHECK(pinned.code() == "return b * b - a * c;");
    pinned.press('i');
    CHECK(pinned.state.step == there + 1);
    look_at_level(pinned.state, 1);
    pinned.press('o');
    CHECK(pinned.code() == "const Truth<Real> real = delta >= Real(0);");
    look_at_level(pinned.state, 0);
    pinned.press('o');  // the rule is done
    CHECK(pinned.code() == "const Real t = first_ahead(t0, t1);");
    pinned.state.step = 2;
    pinned.press('u');  // out of the operator, not of `quadratic`
    CHECK(pinned.code() == "return {dot(D, D), dot(v, D), dot(v, v) - r * r};");
    // At the end nothing is beyond.
    go(pinned.state, pinned.results, StepTo::last);
    const std::size_t last = pinned.state.step;
    pinned.press('o');
    pinned.press('u');
    CHECK(pinned.state.step == last);
}

TEST_CASE("operands lead to the steps that made them, and back") {
    Pinned pinned(tell(350, 350, by_textbook()));
    const std::size_t delta = pinned.find("Δ = ");
    pinned.state.step = delta;
    pinned.press('e');
    CHECK(pinned.state.step == delta - 2);  // b²
    pinned.press('j');
    CHECK(pinned.state.step == delta);
    pinned.press('j', true);
    CHECK(pinned.state.step == delta - 2);
    pinned.press('j');
    pinned.press('e', true);
    CHECK(pinned.state.step == delta - 1);  // ac
    pinned.press('j', true);                // a jump forgets what was ahead
    CHECK(pinned.state.step == delta - 1);
    pinned.state.step = 2;  // P.x − centre.x: the scene's numbers, made by no step
    pinned.press('e');
    CHECK(pinned.state.step == 2);
    // Another story forgets all jumps.
    pinned.results.story = std::make_shared<const Story>(tell(370, 110));
    pinned.results.timeline = timeline(*pinned.results.story);
    follow_steps(pinned.state, pinned.results);
    pinned.press('j');
    CHECK(pinned.state.step == 2);
}

TEST_CASE("only what feeds a number is shown, until one leaves it") {
    Pinned pinned(tell(350, 350, by_textbook()));
    const std::size_t delta = pinned.find("Δ = ");
    pinned.state.step = delta;
    CHECK(hidden_in_words(pinned.state, pinned.results).empty());
    pinned.press('v');
    const std::vector<bool> kept = events_kept(pinned.state, pinned.results);
    const auto count = std::ranges::count(kept, true);
    // v: 3 differences; D·D, v·D, v·v: 5 each; r², v·v − r², b², ac, Δ.
    CHECK(count == 3 + 3 * 5 + 5);
    CHECK(hidden_in_words(pinned.state, pinned.results) ==
          "Only the 23 steps that feed Δ: " + std::to_string(pinned.results.timeline.size() - 23) + " are hidden");
    obey({Key::home, 0, false, false}, pinned.state, pinned.results);
    for (int i = 1; i < 23; ++i) {
        CHECK(kept[pinned.state.step]);
        pinned.press(']');
    }
    CHECK(pinned.state.step == delta);
    pinned.press(']');
    CHECK(pinned.state.step == delta);
    pinned.press('v');
    CHECK_FALSE(pinned.state.stepping.fed);
    pinned.press('v');
    pinned.state.step = delta + 1;  // a click elsewhere
    follow_steps(pinned.state, pinned.results);
    CHECK_FALSE(pinned.state.stepping.fed);
    pinned.state.step = 0;  // no operation
    pinned.press('v');
    CHECK_FALSE(pinned.state.stepping.fed);
}

TEST_CASE("the worst losses come first, and Predict first gives none away") {
    Pinned pinned(story_of_far_sphere(350));
    const std::vector<RankedLoss> all = ranked_losses(pinned.state, pinned.results, 1000);
    REQUIRE(!all.empty());
    CHECK(pinned.results.timeline[all[0].event].formula.starts_with("Δ = "));
    CHECK(all[0].own == 24);
    for (std::size_t i = 1; i < all.size(); ++i) CHECK(all[i - 1].own >= all[i].own);
    CHECK(ranked_losses(pinned.state, pinned.results, 2).size() == 2);

    set_predicting(pinned.state, pinned.results, true);
    const std::size_t delta = all[0].event;
    while (pinned.results.questions[pinned.state.predicting.answers.size()].asked != Asked::bits) {
        pinned.state.step = steps_shown(pinned.state, pinned.results).size() - 1;
        for (const RankedLoss& loss : ranked_losses(pinned.state, pinned.results, 1000)) {
            CHECK(loss.event <= pinned.state.step);
            CHECK(loss.event != delta);
        }
        CHECK_FALSE(row_to_nudge(pinned.state, pinned.results));  // its verdict is to be guessed
        answer(pinned.state, pinned.results, {});
        REQUIRE(pinned.state.predicting.answers.size() < pinned.results.questions.size());
    }
    pinned.state.step = steps_shown(pinned.state, pinned.results).size() - 1;
    CHECK(pinned.state.step == delta);  // it is seen, its loss is not
    for (const RankedLoss& loss : ranked_losses(pinned.state, pinned.results, 1000)) CHECK(loss.event != delta);
    pinned.press('v');
    pinned.press('o');
    pinned.press('u');
    CHECK(pinned.state.step <= delta);
}

TEST_CASE("nudges are made, undone and reset; another surface's test begins without") {
    Pinned pinned(tell(370, 110));
    pinned.state.stepping.pane = StepsPane::nudge;
    follow_steps(pinned.state, pinned.results);
    REQUIRE(pinned.state.stepping.nudged);  // of the surface that is hit
    CHECK(pinned.results.story->surfaces[pinned.state.stepping.nudged_row].number == 4);
    nudge(pinned.state, pinned.results, "P.y", 100);
    nudge(pinned.state, pinned.results, "P.y", -1);
    const auto by = [&] { return pinned.state.stepping.nudged->inputs[1].by; };
    CHECK(by() == 99);
    pinned.state.step = pinned.find("Δ");  // in another surface's test: the nudges stay where they are
    follow_steps(pinned.state, pinned.results);
    CHECK(by() == 99);
    undo_nudge(pinned.state, pinned.results);
    CHECK(by() == 100);
    reset_nudges(pinned.state);
    follow_steps(pinned.state, pinned.results);
    CHECK(by() == 0);
    CHECK(pinned.state.stepping.nudged_row == *pinned.now().place->row);
}

TEST_CASE("functions and their lines are read from a header's text") {
    const SourceFile file{"core/x.hpp", R"(#pragma once
namespace glassbox {
/// Says (something); with { braces }.
template <class Real>
constexpr Real negated(const Vec3<Real, 2>& a) {
    const auto twice = [&](const Real& x) { return x - -x; };
    return twice(-a.x);
}
struct Rule {
    template <class Real>
    Real operator()(const Real& a, const Real& b) const {
        return a - b;  // a - b
    }
    friend bool operator==(const Rule& a, const Rule& b) { return true; }
};
}
)"};
    const std::vector<SourceFunction> found = functions_of(file);
    REQUIRE(found.size() == 3);
    CHECK(found[0].name == "negated");
    CHECK(found[0].is_unary);
    CHECK(found[0].first == 5);
    CHECK(found[0].last == 8);
    CHECK(found[1].name == "Rule");
    CHECK_FALSE(found[1].is_unary);
    CHECK(found[1].first == 11);
    CHECK(found[2].name == "operator==");
    CHECK(only_line_with(file, found[0], "-", false) == 6);
    CHECK(only_line_with(file, found[0], "-", true) == 0);  // on two lines
    CHECK(only_line_with(file, found[1], "-", false) == 12);
    CHECK(only_line_with(file, found[1], "*", false) == 0);
}

TEST_CASE("code is cut into pieces by kind, and broken at blanks") {
    const std::vector<CodePiece> pieces = code_pieces("    return 2 * dot(n, 0x1p-53); // l·n");
    const auto has = [&](CodeKind kind, std::string_view text) {
        return std::ranges::find(pieces, CodePiece{kind, text}) != pieces.end();
    };
    CHECK(has(CodeKind::keyword, "return"));
    CHECK(has(CodeKind::number, "2"));
    CHECK(has(CodeKind::plain, "dot"));
    CHECK(has(CodeKind::number, "0x1p-53"));
    CHECK(has(CodeKind::comment, "// l·n"));
    std::string joined;
    for (const CodePiece& piece : pieces) joined += piece.text;
    CHECK(joined == "    return 2 * dot(n, 0x1p-53); // l·n");
    for (const SourceFile& file : core_sources())
        for (const std::string_view line : lines(file))
            for (const std::size_t columns : {20u, 40u, 80u}) {
                std::string text;
                std::size_t widest = 0;
                for (const CodeRow& row : code_rows(line, columns)) {
                    std::string row_text(row.indent, ' ');
                    for (const CodePiece& piece : row.pieces) row_text += piece.text, text += piece.text;
                    while (row_text.ends_with(' ')) row_text.pop_back();
                    if (row_text.find(' ', row.indent) != std::string::npos)
                        widest = std::max(widest, columns_of(row_text));
                }
                CHECK(text == line.substr(std::min(line.find_first_not_of(' '), line.size())));
                CAPTURE(line);
                CHECK(widest <= columns);
            }
}

TEST_CASE("one surface is lit up: what the mouse is on, or what the present step is about") {
    Pinned pinned(tell(350, 350, by_textbook()));
    ViewerState& state = pinned.state;
    const Story& story = *pinned.results.story;
    for (state.step = 0; state.step < pinned.results.timeline.size(); ++state.step) {
        const Event& event = pinned.now();
        const auto row = event.surface ? event.surface : event.place ? event.place->row : std::nullopt;
        if (row) CHECK(lit_surface(state, pinned.results) == story.surfaces[*row].number);
        if (row) CHECK(lit_in_story(state, pinned.results) == &story.surfaces[*row]);
    }
    state.step = pinned.find("Δ = ");
    state.pointing_at = 5;
    CHECK(lit_surface(state, pinned.results) == 0u);  // the mouse came there in this very frame
    begin_pointing(state);
    CHECK(lit_surface(state, pinned.results) == 5u);
    begin_pointing(state);
    CHECK(lit_surface(state, pinned.results) == 0u);
    state.page = Page::inspector;
    CHECK_FALSE(lit_surface(state, pinned.results));
}
