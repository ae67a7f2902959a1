// What the flag -ffp-contract=off is for: without it a·b − c·d is computed as fma(a, b, −c·d), which is not the
// negative of fma(c, d, −a·b), and rays slip between two triangles that share an edge.
#include <doctest.h>

#include "lost_rays.hpp"

TEST_CASE("with contraction on, thousands of a million rays aimed at shared edges are lost") {
    if (!__builtin_cpu_supports("fma")) {
        MESSAGE("skipped: this processor has no fused multiply-add");
        return;
    }
    const int lost = glassbox::test::lost_rays(1'000'000);
    MESSAGE(lost << " of 1000000 rays lost");
    CHECK(lost > 1000);
}
