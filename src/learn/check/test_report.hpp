#pragma once
#include <string>
#include <vector>

#include "learn/check/test_run.hpp"
#include "learn/subprocess/subprocess.hpp"

namespace glassbox::learn {

/// What a test program reported (runner/main.cpp), line by line, and how it ended.
struct Report {
    std::vector<CaseResult> cases;
    std::string disturbed;  ///< why they cannot be trusted, in words; "" if they can
};

/// Reads a report. Lines without the nonce are not the reporter's. A case that began and did not end is the one in
/// which the program died.
Report read_report(const std::string& text, const std::string& nonce, const Outcome& outcome);

}  // namespace glassbox::learn
