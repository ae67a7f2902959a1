// How checks count in our own tests. Those of a learner have src/learn/check/runner/main.cpp.
#include <doctest.h>

#include <iomanip>
#include <sstream>
#include <support/ulps.hpp>

namespace glassbox::test {

void passed() { CHECK(true); }
void passed(const char*, int, const Compared&) { passed(); }

void failed(const Difference& difference) {
    std::ostringstream text;
    text << difference.expression << ": expected " << difference.expected << ", got " << difference.got << ", "
         << std::setprecision(3) << difference.ulps << " ulps apart";
    ADD_FAIL_CHECK_AT(difference.file, difference.line, text.str());
}

}  // namespace glassbox::test
