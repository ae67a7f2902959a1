// What a teacher reads: a page, a table, numbers for a spreadsheet.
#include "learn/report/page.hpp"

#include <doctest.h>

using namespace glassbox;
using namespace glassbox::learn;

namespace {

/// Ada has passed lesson 1 and written one of two functions of lesson 2; Bo has given up on lesson 1, and his lesson 2
/// does not compile.
std::vector<LearnerStanding> two_learners() {
    LessonStanding passed{.number = 1, .title = "Rays", .grade = Grade::passed};
    passed.functions = {{"dot", "vec3.hpp", State::passed, 2}};
    passed.cases = passed.cases_passed = 3;
    passed.runs = 4;
    passed.mine = passed.ours = Image(2, 2, {0, 255, 0});

    LessonStanding failing{.number = 2, .title = "Spheres", .grade = Grade::failing};
    failing.functions = {{"nearest", "crossing.hpp", State::passed, 0}, {"normal", "sphere.hpp", State::failing, 1}};
    failing.cases = 10;
    failing.cases_passed = 7;
    failing.cases_waiting = 1;
    failing.wrong = "a < b && \"c\"";
    failing.mistake = "the normal points inwards";
    failing.ours = Image(2, 2);
    Image mine(2, 2);
    mine.at(1, 0) = {255, 0, 0};
    failing.mine = mine;

    LessonStanding given_up = passed;
    given_up.gave_up = true;
    LessonStanding broken{.number = 2, .title = "Spheres", .grade = Grade::does_not_compile};
    broken.functions = failing.functions;
    broken.no_picture = "it does not compile";
    return {{"Ada", {passed, failing}}, {"Bo, \"the\" <second>", {given_up, broken}}};
}

}  // namespace

TEST_CASE("a table has a row for each learner and a column for each lesson, in line") {
    const std::string table = to_table(two_learners());
    CHECK(
        table.starts_with("learner             1 Rays       2 Spheres\n"
                          "Ada                 ✓            1/2\n"
                          "Bo, \"the\" <second>  ✓ (gave up)  ✗\n"));
}

TEST_CASE("in CSV commas and quotes of a name are quoted") {
    const std::string csv = to_csv(two_learners());
    // of 2 x 2 pixels one is red where ours is black
    CHECK(csv.find("\nAda,1,passed,1,1,3,0,3,0,2,4,no\n") != std::string::npos);
    CHECK(csv.find("\nAda,2,failing,1,2,7,1,10,1,1,0,no\n") != std::string::npos);
    CHECK(csv.find("\n\"Bo, \"\"the\"\" <second>\",1,passed,1,1,3,0,3,0,2,4,yes\n") != std::string::npos);
    CHECK(csv.find(",2,does not compile,1,2,0,0,0,,1,0,no\n") != std::string::npos);
}

TEST_CASE("a page shows names, code and messages as text, never as HTML") {
    const std::string html = to_html(two_learners());
    CHECK(html.find("a &lt; b &amp;&amp; &quot;c&quot;") != std::string::npos);
    CHECK(html.find("Bo, &quot;the&quot; &lt;second&gt;") != std::string::npos);
    CHECK(html.find("<second>") == std::string::npos);
}

TEST_CASE("a page says how far pictures differ, and why one is missing") {
    const std::string html = to_html(two_learners());
    CHECK(html.find("no pixel differs") != std::string::npos);
    CHECK(html.find("1 of 4 pixels differ, 25.0 % (orange)") != std::string::npos);
    CHECK(html.find("No picture: it does not compile.") != std::string::npos);
}

TEST_CASE("what waits for a function to be written has not failed") {
    LessonStanding lesson{.number = 2, .title = "Spheres", .grade = Grade::unfinished};
    lesson.functions = {{"Textbook", "sphere.hpp", State::not_written}, {"intersect", "sphere.hpp", State::waiting}};
    lesson.functions[1].waits_for = "Textbook<>";
    lesson.cases = 5;
    lesson.cases_passed = 2;
    lesson.cases_waiting = 3;
    lesson.wrong = "Next to write: Textbook";
    const std::string html = to_html({{"Ada", {lesson}}});
    CHECK(html.find("2 of 5 tests (3 wait for a function to be written)") != std::string::npos);
    CHECK(html.find("… waits for Textbook&lt;&gt;") != std::string::npos);
    CHECK(html.find("… unfinished") != std::string::npos);
    CHECK(html.find("<h3>What comes next</h3>\n<pre>Next to write: Textbook</pre>") != std::string::npos);
    CHECK(html.find("✗") == std::string::npos);
    CHECK(to_csv({{"Ada", {lesson}}}).ends_with("Ada,2,unfinished,0,2,2,3,5,,0,0,no\n"));
}

TEST_CASE("a page asks nothing of any other file or host") {
    const std::string html = to_html(two_learners());
    for (std::size_t at = html.find("src=\""); at != std::string::npos; at = html.find("src=\"", at + 1))
        CHECK(html.substr(at + 5, 22) == "data:image/png;base64,");
    for (const char* elsewhere : {"http:", "https:", "<script", "<link", "url("}) {
        CAPTURE(elsewhere);
        CHECK(html.find(elsewhere) == std::string::npos);
    }
    // the first bytes of every PNG, 89 50 4E 47 0D 0A, are iVBORw0K in base 64
    CHECK(html.find("base64,iVBORw0K") != std::string::npos);
}

TEST_CASE("one learner needs no table of all") {
    CHECK(to_html({two_learners().front()}).find("<h1 id=\"all\">") == std::string::npos);
    CHECK(to_html(two_learners()).find("<h1 id=\"all\">") != std::string::npos);
}
