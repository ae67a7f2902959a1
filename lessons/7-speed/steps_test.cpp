// However fast, it is the same picture.
#include <doctest.h>

#include <baseline.hpp>
#include <steps.hpp>

TEST_CASE("each step of speed draws the paper's picture, byte for byte") {
    const auto expected = glassbox::render_as_published(404, 404, .2, 1, .2);
    for (const glassbox::Step& step : glassbox::steps_of_speed()) {
        CAPTURE(step.name);
        CHECK(step.draw(404, 404) == expected);
    }
}
