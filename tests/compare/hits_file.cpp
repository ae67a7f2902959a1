// What another program says of rays: read generously, and refused where nothing sensible can be meant.
#include "compare/hits_file.hpp"

#include <doctest.h>

#include <fstream>

#include "output/folder.hpp"
#include "scene/error.hpp"

using namespace glassbox;
using namespace glassbox::test;

namespace {

constexpr std::size_t rays = 3, surfaces = 2;

struct Table : Folder {
    Claims read(const std::string& text) const {
        std::ofstream(*this / "h.csv") << text;
        return read_hits(*this / "h.csv", rays, surfaces);
    }
    /// The message without the folder's name.
    std::string refused(const std::string& text) const {
        const std::string message = message_of<Error>([&] { read(text); });
        const std::size_t name = message.find("h.csv");
        return name == std::string::npos ? message : message.substr(name);
    }
};

bool is_hit(const Claim& claim, std::optional<std::size_t> surface, std::optional<double> t) {
    return claim.answer == Shot::Answer::hit && claim.surface == surface && claim.t == t;
}

}  // namespace

TEST_CASE("as shoot writes it; columns in any order; others beside them; spaces, capitals, blank lines, Windows") {
    const Table table;
    for (const char* text :
         {"ray,verdict,surface,t,t_error,decided,hits\n0,hit,1,2.5,0,filter,1\n1,miss,,,,exact,0\n2,invalid,,,,,0\n",
          "t,surface,verdict\n2.5,1,hit\n,,miss\n,,invalid\n",
          "verdict,t,ray,surface\ninvalid,,2,\nhit,2.5,0,1\nmiss,,1,\n",
          " ray , verdict,surface,t\r\n0,HIT, 1 ,0x1.4p1\r\n\r\n1,Miss,-1,inf\r\n2,Invalid,,\r\n"}) {
        CAPTURE(text);
        const Claims claims = table.read(text);
        REQUIRE(claims.rays.size() == rays);
        CHECK(is_hit(claims.rays[0], 1, 2.5));
        CHECK(claims.rays[1].answer == Shot::Answer::miss);
        CHECK(claims.rays[2].answer == Shot::Answer::invalid);
    }
}

TEST_CASE("surface and t may be left out") {
    const Table table;
    CHECK(is_hit(table.read("verdict\nhit\nmiss\nmiss\n").rays[0], {}, {}));
    CHECK(is_hit(table.read("verdict,surface,t\nhit,,3\nmiss,,\nmiss,,\n").rays[0], {}, 3.0));
}

TEST_CASE("how many digits t are written with; of shortened ones half of the last is the writing's") {
    const Table table;
    const Claims six = table.read("verdict,t\nhit,350.123\nhit,0.0012345\nhit,7\n");
    CHECK(six.digits == 6);
    CHECK(six.is_shortened(16));
    // 350.123 may be anything from 350.1225 to 350.1235.
    CHECK(six.half_digit_if_shortened(350.123, 16) == doctest::Approx(0.0005));
    // Six digits behind the point: 350.123456 has nine, and 0.001235 is no surer than the sixth place.
    const Claims fixed = table.read("verdict,t\nhit,350.123456\nhit,0.001235\nhit,7.000000\n");
    CHECK(fixed.half_digit_if_shortened(0.001235, 16) == doctest::Approx(0.0000005));
    CHECK(table.read("verdict,t\nhit,350.12345678901234\nmiss,\nmiss,\n").half_digit_if_shortened(350, 16) == 0);
    CHECK(table.read("verdict,t\nhit,350\nhit,12\nmiss,\n").half_digit_if_shortened(350, 16) == 0);  // whole numbers
    CHECK(table.read("verdict,t\nhit,0x1.8p3\nhit,12.345\nmiss,\n").half_digit_if_shortened(12, 16) == 0);
}

TEST_CASE("what cannot be meant is refused, with its place and what would be right") {
    const Table table;
    const std::string header = "ray,verdict,surface,t\n";
    CHECK(table.refused("") ==
          "h.csv:1:1: error: the first line must name the columns, 'verdict' among them, as in ray,verdict,surface,t");
    CHECK(table.refused("ray,surface\n0,1\n").starts_with("h.csv:1:1: error: the first line must name"));
    CHECK(table.refused("verdict,t,t\n").starts_with("h.csv:1:11: error: a second column 't'"));
    CHECK(table.refused(header + "0,hti,1,2\n") == "h.csv:2:3: error: 'hti' is no verdict; did you mean 'hit'?");
    CHECK(table.refused(header + "0,hit,2,2\n") ==
          "h.csv:2:7: error: surface '2' is not there; they are counted from 0 to 1");
    CHECK(table.refused(header + "3,hit,1,2\n") ==
          "h.csv:2:1: error: ray '3' is not there; they are counted from 0 to 2");
    CHECK(table.refused(header + "0,hit,1,far\n").starts_with("h.csv:2:9: error: 'far' is not a number"));
    CHECK(table.refused(header + "0,miss,,\n0,miss,,\n") ==
          "h.csv:3:1: error: ray 0 is there twice; tell of each ray once");
    CHECK(table.refused(header + "0,miss,,\n2,miss,,\n") ==
          "h.csv:4:1: error: ray 1 is missing: there are 3 rays, and 2 rows here");
    CHECK(table.refused(header + "0,miss,\n") == "h.csv:2:8: error: 3 fields in this row; the header names 4");
    CHECK(table.refused("verdict\nmiss\nmiss\nmiss\nmiss\n") ==
          "h.csv:5:1: error: a row more than there are rays, 3; a row each, in their order");
    CHECK(message_of<Error>([&] { read_hits(table / "none.csv", rays, surfaces); }).ends_with("there is no such file"));
}
