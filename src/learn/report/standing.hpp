#pragma once
#include <optional>
#include <string>
#include <vector>

#include "learn/course/progress.hpp"
#include "render/image.hpp"

namespace glassbox::learn {

/// How a learner stands with one function.
struct FunctionStanding {
    std::string name, header = {};
    State state = State::unknown;
    int hints = 0;               ///< how many were shown
    std::string waits_for = {};  ///< the function that it waits for, if it waits
};

/// The result of a lesson's tests. Unfinished: nothing fails, but something is not written yet.
enum class Grade { not_begun, does_not_compile, failing, unfinished, passed };

/// How a learner stands in a lesson, as a teacher wants to know it.
struct LessonStanding {
    int number = 0;
    std::string title;
    Grade grade = Grade::not_begun;
    std::vector<FunctionStanding> functions = {};
    int cases = 0, cases_passed = 0;  ///< of the tests that ran, one for each scalar
    int cases_waiting = 0;            ///< those that cannot be run until a function is written
    int runs = 0;                     ///< how often the learner had them tested
    bool gave_up = false;             ///< the solution was shown before they passed
    std::string wrong = {};           ///< the first thing that is wrong, in lines; "" if nothing is
    std::string mistake = {};         ///< what it looks like, if it is a classic mistake
    std::string description = {};     ///< else what its checks have in common
    std::optional<Image> mine = {};   ///< the lesson's picture with the learner's headers
    std::optional<Image> ours = {};   ///< and with ours
    std::string no_picture = {};      ///< why there is none
};

/// How a learner stands in all lessons.
struct LearnerStanding {
    std::string learner;
    std::vector<LessonStanding> lessons;
    std::vector<std::string> notes = {};  ///< on what was handed in: where it was found, what is missing
};

int functions_passed(const LessonStanding& lesson);

/// Returns how many pixels of the learner's picture differ from ours; none if there is no picture of the same size.
std::optional<int> pixels_differing(const LessonStanding& lesson);

}  // namespace glassbox::learn
