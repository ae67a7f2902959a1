// Three-valued logic, by its truth tables (Kleene, Introduction to Metamathematics, 1952, section 64).
#include <kleene.hpp>

#include <doctest.h>

#include <initializer_list>

using glassbox::Kleene;

namespace {

constexpr Kleene yes = true, no = false, maybe = Kleene::undecided();

constexpr bool alike(Kleene a, Kleene b) { return surely(a) == surely(b) && possibly(a) == possibly(b); }

}  // namespace

TEST_CASE("surely and possibly") {
    CHECK((surely(yes) && possibly(yes)));
    CHECK((!surely(maybe) && possibly(maybe)));
    CHECK((!surely(no) && !possibly(no)));
}

TEST_CASE("not swaps yes and no, and leaves what is undecided") {
    CHECK(alike(!yes, no));
    CHECK(alike(!no, yes));
    CHECK(alike(!maybe, maybe));
}

TEST_CASE("and is the lesser of the two: one no settles it") {
    for (const Kleene k : {yes, no, maybe}) {
        CHECK(alike(k & yes, k));
        CHECK(alike(yes & k, k));
        CHECK(alike(k & no, no));
        CHECK(alike(no & k, no));
        CHECK(alike(k && yes, k));
        CHECK(alike(no && k, no));
    }
    CHECK(alike(maybe & maybe, maybe));
    CHECK(alike(maybe && maybe, maybe));
}

TEST_CASE("unequal needs to know both sides") {
    CHECK(alike(yes != no, yes));
    CHECK(alike(no != yes, yes));
    CHECK(alike(yes != yes, no));
    CHECK(alike(no != no, no));
    for (const Kleene k : {yes, no, maybe}) {
        CHECK(alike(k != maybe, maybe));
        CHECK(alike(maybe != k, maybe));
    }
}
