#pragma once
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "scene/error.hpp"

namespace glassbox::learn {

/// A function to be written.
struct Function {
    std::string name;                ///< as in not_written("nearest")
    std::string header;              ///< the file that it is in
    std::vector<std::string> tests;  ///< a test case whose name contains one of these tests it; the first, by itself
    std::string hints[3];            ///< a question, the formula, the line of code: the whole body
    std::string returns = {};        ///< its type: not_written<Roots<Real>>("Textbook")
    std::string turn = {};           ///< what stands above it in the starter: "// Your turn: …"; may be empty
    std::string rule = {};           ///< by which the viewer shows its failing rays: "textbook"; "" for the usual one
    Place place = {};                ///< where exercise.toml has it
};
inline constexpr int hint_tiers = 3;

/// How a lesson's headers draw the learner's own picture: by bounds, where the lesson is about bounds and plain double
/// would show no change; not at all, where none of our tracers includes the headers.
enum class OwnPicture { in_double, by_bounds, none };

/// What one lesson asks the learner to write: its exercise.toml.
struct Exercise {
    int number = 0;                ///< 2
    std::string name;              ///< "2-spheres", its folder in lessons/ and in the learner's folder
    std::filesystem::path lesson;  ///< the folder in lessons/
    std::string title;             ///< "Spheres"
    std::string sentence;          ///< what the learner can do at the end
    std::string core;  ///< the folder whose headers are replaced, from the project's root: "src/core/2-spheres"
    std::vector<std::string> headers;  ///< in the order of writing
    std::vector<std::string> tests;    ///< source files, from the project's root
    std::string scene;                 ///< shows mine and ours, from the project's root
    int stage = 0;                     ///< of its pictures
    OwnPicture own_picture = OwnPicture::in_double;
    std::vector<Function> functions;  ///< in the order of writing
};

/// A classic mistake: a small patch of the solution.
struct Mistake {
    std::string name;        ///< "far-root-missing"
    std::string header;      ///< the file that it is made in
    std::string instead_of;  ///< stands once in the solution
    std::string writes;      ///< what the mistake has there
    std::string looks_like;  ///< the symptom, the cause, where to look
    Place place;             ///< where mistakes.toml has it
};

/// Reads lessons/N-name/exercise.toml. Throws Error with file, line and column for anything invalid.
Exercise read_exercise(const std::filesystem::path& lesson);

/// Reads lessons/N-name/mistakes.toml, in the same way.
std::vector<Mistake> read_mistakes(const Exercise& exercise);

/// The exercises of all lessons in root/lessons that have one, by number.
std::vector<Exercise> read_exercises(const std::filesystem::path& root);

/// Returns the function that a test case is about: the first one that claims it; null if none does.
const Function* function_tested_by(const Exercise& exercise, std::string_view test_case);

/// Returns the solution's text with the mistake in it. Throws Error if `instead_of` does not occur exactly once.
std::string with_mistake(const std::string& solution, const Mistake& mistake);

}  // namespace glassbox::learn
