#pragma once
#include <string>

#include "learn/check/judgement.hpp"
#include "learn/check/test_run.hpp"

namespace glassbox::learn {

/// Describes how the function that is looked at first fails, by what its checks have in common: with which inputs it is
/// right and with which wrong, and how what came out differs from what should have. Each sentence is true of all checks
/// that it speaks of; nothing is guessed. "" where no check was kept, as in a program that died.
std::string description(const Exercise& exercise, const TestRun& run, const Judgement& judgement);

}  // namespace glassbox::learn
