#pragma once
#include <optional>
#include <string>
#include <vector>

#include "learn/build/first_error.hpp"
#include "learn/course/progress.hpp"
#include "render/pixel.hpp"

namespace glassbox::learn {

/// A line of what there is to say of a failure: "expected", "5".
struct ToldRow {
    std::string name, value;

    bool operator==(const ToldRow&) const = default;
};

/// The ray that a failed test traced last, as a scene.
struct ToldRay {
    std::string toml;
    Pixel pixel;               ///< whose ray it is
    std::string option, rule;  ///< the rule that the test is about: "sphere", "textbook"; "" for the usual one
};

/// How a test case went, in all scalars in which it was tried.
struct ToldCase {
    std::string name;                  ///< without its scalar
    State state = State::passed;       ///< passed, failing or waiting
    std::string waits_for;             ///< the function that must be written first
    std::vector<std::string> scalars;  ///< in which it went so; none for a case that knows no scalars
    std::vector<ToldRow> rows;         ///< of the first failure
    std::optional<ToldRay> ray;        ///< of that failure
};

/// How a function stands, and the cases that test it.
struct ToldFunction {
    std::string name;  ///< "" for cases that are about no function
    State state = State::unknown;
    std::string waits_for;
    std::vector<ToldCase> cases;
};

/// How a lesson's tests went, in words: values alone, nothing of the programs that were run.
struct ToldTests {
    enum class Stand {
        not_there,  ///< the lesson is not begun, a header was deleted, or the machine cannot do it: `words` say why
        running,
        does_not_compile,  ///< `rows` say why
        done,
    };
    Stand stand = Stand::running;
    int lesson = 0;
    bool passed = false;  ///< all of it
    std::string words;    ///< in a sentence or two
    std::optional<CompileError> error;
    std::vector<ToldRow> rows;            ///< of the error
    std::vector<ToldFunction> functions;  ///< in the order of writing
    std::string first;                    ///< the case to look at first; "" if none fails
    std::vector<ToldRow> about_first;     ///< what it looks like, and what the checks show
};

/// Returns the case of that name; null if there is none.
const ToldCase* find_case(const ToldTests& tests, const std::string& name);

}  // namespace glassbox::learn
