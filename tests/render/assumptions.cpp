// What the bounds assume: it holds here, and when it does not, that is noticed.
#include "render/assumptions.hpp"

#include <doctest.h>

#include <algorithm>
#include <cfenv>

#ifdef __SSE2__
#include <xmmintrin.h>
#endif

#include "engine/vector_check.hpp"

using namespace glassbox;

namespace {

/// Returns "what: not in" for everything that does not hold.
std::vector<std::string> broken(const std::vector<Assumption>& assumptions) {
    std::vector<std::string> names;
    for (const Assumption& each : assumptions)
        if (!each.not_in.empty()) names.push_back(each.what + ": " + each.not_in);
    return names;
}

bool has(const std::vector<std::string>& names, const std::string& name) {
    return std::find(names.begin(), names.end(), name) != names.end();
}

using Names = std::vector<std::string>;

}  // namespace

TEST_CASE("all of it holds here, in every thread") {
    CHECK(broken(try_assumptions()) == Names{});
    CHECK(broken(try_assumptions_in_threads()) == Names{});
}

TEST_CASE("another rounding mode is noticed, in each scalar") {
    for (const int mode : {FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO}) {
        CAPTURE(mode);
        std::fesetround(mode);
        const Names here = broken(try_assumptions());
        std::fesetround(FE_TONEAREST);
        CHECK(has(here, "rounding is to nearest, ties to even: float, double, long double"));
    }
    CHECK(broken(try_assumptions()) == Names{});
}

TEST_CASE("vectors of each kind compute what single numbers do") {
    const std::vector<engine::VectorKind> kinds = engine::try_vectors();
    CHECK_FALSE(kinds.empty());
    for (const engine::VectorKind& kind : kinds) CHECK_MESSAGE(kind.is_right, kind.name);
}

#ifdef __SSE2__

namespace {

constexpr unsigned flush_to_zero = 0x8000, denormals_are_zero = 0x40;  // of SSE's control word, MXCSR

/// Returns what does not hold when these bits are set; long double is computed without SSE.
template <class Try>
Names broken_with(unsigned bits, const Try& assumptions) {
    const unsigned before = _mm_getcsr();
    _mm_setcsr(before | bits);
    const std::vector<Assumption> found = assumptions();
    _mm_setcsr(before);
    return broken(found);
}

const std::string made = "results below the normal numbers are kept, not flushed to 0: float, double";
const std::string taken = "numbers below the normal ones are taken as they are, not as 0: float, double";

}  // namespace

TEST_CASE("flushed subnormal numbers are noticed, as results and as operands") {
    // A float below the normal ones is also what some doubles become.
    CHECK(broken_with(flush_to_zero, try_assumptions) == Names{made, "a double becomes the nearest float: float"});
    CHECK(broken_with(denormals_are_zero, try_assumptions) == Names{taken});
    const Names everywhere = broken_with(flush_to_zero | denormals_are_zero, try_assumptions_in_threads);
    CHECK(has(everywhere, made));
    CHECK(has(everywhere, taken));
    CHECK(broken(try_assumptions_in_threads()) == Names{});
}

#endif
