#include "output/table.hpp"

#include <doctest.h>

#include <limits>
#include <stdexcept>
#include <string>
#include <string_view>

using namespace glassbox;

namespace {

std::string table_of(std::span<const Channel> channels) {
    static const Measurement any{"any", "", "", Scale::sequential, Source::hit, {}, {}, {}};
    const Measured measured{&any, channels};
    std::string text;
    table({&measured, 1}, [&](std::span<const std::byte> piece) {
        text.append(reinterpret_cast<const char*>(piece.data()), piece.size());
    });
    return text;
}

}  // namespace

TEST_CASE("a row a pixel, from the top left, a column a plane") {
    const Channel channels[] = {{"depth", 2, 2, {1, 2, 3, 4}}, {"n.l", 2, 2, {0.1, -0.25, no_value, 1e300}}};
    CHECK(table_of(channels) ==
          "x,y,depth,n.l\n"
          "0,0,1,0.1\n"
          "1,0,2,-0.25\n"
          "0,1,3,\n"
          "1,1,4,1e+300\n");
}

TEST_CASE("numbers are the shortest that read back the same") {
    const double infinity = std::numeric_limits<double>::infinity();
    const double values[] = {1.0 / 3, 0.1 + 0.2, 5e-324, -1.7976931348623157e308, -0.0, infinity, -infinity};
    const Channel plane{"v", 7, 1, {std::begin(values), std::end(values)}};
    CHECK(table_of({&plane, 1}) ==
          "x,y,v\n"
          "0,0,0.3333333333333333\n"
          "1,0,0.30000000000000004\n"
          "2,0,5e-324\n"
          "3,0,-1.7976931348623157e+308\n"
          "4,0,-0\n"
          "5,0,inf\n"
          "6,0,-inf\n");
}

TEST_CASE("channels of different sizes are a mistake of the caller") {
    const Channel channels[] = {{"a", 2, 1, {1, 2}}, {"b", 1, 2, {1, 2}}};
    CHECK_THROWS_AS(table_of(channels), std::invalid_argument);
}
