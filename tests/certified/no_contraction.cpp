// With Glassbox's flags, each operation rounded as written, no ray slips between two triangles.
#include <doctest.h>

#include "lost_rays.hpp"

TEST_CASE("none of a million rays aimed at shared edges is lost") { CHECK(glassbox::test::lost_rays(1'000'000) == 0); }
