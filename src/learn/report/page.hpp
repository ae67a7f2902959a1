#pragma once
#include <string>
#include <vector>

#include "learn/report/standing.hpp"

namespace glassbox::learn {

/// Returns a page for a teacher, in HTML and self-contained: for each learner and lesson the functions, the first thing
/// that is wrong, the pictures and their difference; for several learners a table at the end. `remark` is a sentence on
/// how they were graded.
std::string to_html(const std::vector<LearnerStanding>& learners, const std::string& remark = "");

/// Returns the table alone, for a terminal: a row per learner, a column per lesson, ending in a newline.
std::string to_table(const std::vector<LearnerStanding>& learners);

/// The same as CSV:
/// learner,lesson,verdict,functions_passed,functions,tests_passed,tests_waiting,tests,pixels_differing,hints,runs,gave_up.
std::string to_csv(const std::vector<LearnerStanding>& learners);

}  // namespace glassbox::learn
