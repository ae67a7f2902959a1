#pragma once
#include <chrono>

namespace glassbox::test {

/// Ends this program when it has run so long, and prints the stack of each of its threads to standard error: a test
/// that hangs can be mended only by who knows where. Does nothing where the system is not Linux with glibc.
void start_watchdog(std::chrono::seconds limit);

}  // namespace glassbox::test
