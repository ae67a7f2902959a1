#pragma once
#include <functional>
#include <stop_token>

#include "learn/course/workspace.hpp"
#include "learn/told_tests.hpp"

namespace glassbox::learn {

/// Tests a lesson as `learn test` does, remembers how it stands, and tells all of it. Calls `tell` with every change as
/// it comes: what takes long, what is known already, the end. Nothing more is told once it is asked to stop.
void tell_tests(const Workspace& workspace, const Exercise& exercise, const std::function<void(ToldTests)>& tell,
                const std::stop_token& stop = {});

}  // namespace glassbox::learn
