#include <doctest.h>

#include "support/watchdog.hpp"

int main(int argc, char** argv) {
    glassbox::test::start_watchdog(std::chrono::minutes(14));  // before ctest ends it without a word: TIMEOUT 900
    return doctest::Context(argc, argv).run();
}
