#include <doctest.h>

#include "support/stuck.hpp"

int main(int argc, char** argv) {
    glassbox::test::tell_where_it_is_stuck_after(840);  // ctest ends it, without a word, after 900: CMakeLists.txt
    return doctest::Context(argc, argv).run();
}
