#pragma once
#include <string>
#include <vector>

#include "learn/check/test_run.hpp"
#include "learn/subprocess/subprocess.hpp"

namespace glassbox::learn {

/// What a test program reported (runner/main.cpp), line by line, and how it ended.
struct Report {
    std::vector<CaseResult> cases;
    std::vector<CheckMade> checks;
    std::string disturbed;  ///< why they cannot be trusted, in words; "" if they can
};

/// Reads a report. Ignores lines without the nonce: the reporter did not write them. The program died in the case that
/// began and did not end.
Report read_report(const std::string& text, const std::string& nonce, const Outcome& outcome);

}  // namespace glassbox::learn
