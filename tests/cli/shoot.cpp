// `glassbox shoot`: a table of rays in, a table of hits out.
#include <doctest.h>

#include <algorithm>

#include "cli/program.hpp"

using namespace glassbox::test;

namespace {

constexpr const char* rays_header = "ox,oy,oz,dx,dy,dz\n";
constexpr const char* hits_header = "ray,verdict,surface,t,t_error,decided,hits\n";

/// A unit ball (surface 0), a triangle at z = −5 (1), and a square of two faces at z = −7, cut along y = x (2, the
/// lower one, and 3).
struct Workplace : Folder {
    Workplace() {
        write(*this / "s.toml",
              "[[mesh]]\nfile = 'square.obj'\n"
              "[[triangle]]\nvertices = [[0, 0, -5], [4, 0, -5], [0, 4, -5]]\n"
              "[[sphere]]\ncenter = [0, 0, 0]\nradius = 1\n");
        write(*this / "square.obj", "v 0 0 -7\nv 4 0 -7\nv 4 4 -7\nv 0 4 -7\nf 1 2 3 4\n");
    }

    /// Returns the hits of these rays, without the header, in plain double.
    std::string shoot(const std::string& rays, const Arguments& more = {}) const {
        write(*this / "r.csv", rays);
        Arguments arguments{"shoot", "s.toml", "--rays", "r.csv", "--scalar", "double"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        const Ran ran = run_glassbox(arguments, {.folder = path});
        CHECK(ran.status == 0);
        CHECK(ran.err == "");
        REQUIRE(ran.out.starts_with(hits_header));
        return ran.out.substr(std::string(hits_header).size());
    }

    /// The same, for a single row.
    std::string shoot_row(const std::string& row) const { return shoot(rays_header + row + "\n"); }
};

}  // namespace

TEST_CASE("verdict, surface, t and number of hits") {
    const Workplace folder;
    CHECK(folder.shoot_row("0,0,10,0,0,-1") == "0,hit,0,9,,,4\n");      // the ball, and a corner of all three others
    CHECK(folder.shoot_row("1.5,1,10,0,0,-1") == "0,hit,1,15,,,2\n");   // from z = 10 to −5; the lower face behind
    CHECK(folder.shoot_row("1.5,1,1,0,0,-3") == "0,hit,1,2,,,2\n");     // 6 in steps of 3
    CHECK(folder.shoot_row("1,1.5,-6,0,0,-0.5") == "0,hit,3,2,,,1\n");  // 1 in steps of a half
    CHECK(folder.shoot_row("0,0,0,0,0,0.5") == "0,hit,0,2,,,1\n");      // from inside: the far side
    CHECK(folder.shoot_row("1,0,3,0,0,-1") == "0,hit,0,3,,,3\n");       // tangent; then on edges of 1, 2 but not of 3
    CHECK(folder.shoot_row("9,9,9,0,0,-1") == "0,miss,,,,,0\n");
    CHECK(folder.shoot_row("1.5,1,-7,0,0,-1") == "0,miss,,,,,0\n");  // starts on the square: t > 0, not 0
}

TEST_CASE("a ray that is no ray is invalid") {
    const Workplace folder;
    for (const char* row : {"0,0,3,0,0,0", "0,0,3,-0,0,-0.0", "nan,0,3,0,0,-1", "0,inf,3,0,0,-1", "0,0,3,0,0,-inf",
                            "0,0,3,0,NaN,1", "0,0,3,-infinity,0,1", "-nan,0,0,0,0,1"})
        CHECK_MESSAGE(folder.shoot_row(row) == "0,invalid,,,,,0\n", row);
}

TEST_CASE("a row a ray, counted from 0, in their order; none for no rays") {
    const Workplace folder;
    const std::string three = "1.5,1,-6,0,0,-1\n9,9,9,0,0,-1\n0,0,3,0,0,0\n";
    CHECK(folder.shoot(rays_header + three) == "0,hit,2,1,,,1\n1,miss,,,,,0\n2,invalid,,,,,0\n");
    CHECK(folder.shoot(rays_header) == "");
    CHECK(folder.shoot("ox,oy,oz,dx,dy,dz") == "");
    std::string many = rays_header;
    for (int i = 0; i < 20000; ++i) many += three;
    const std::string hits = folder.shoot(many);
    CHECK(std::count(hits.begin(), hits.end(), '\n') == 60000);
    CHECK(hits.ends_with("59997,hit,2,1,,,1\n59998,miss,,,,,0\n59999,invalid,,,,,0\n"));
    CHECK(folder.shoot(many, {"--threads", "3"}) == hits);
}

TEST_CASE(
    "how tables of numbers are written elsewhere: hexadecimal, spaces, Windows, old Macs, blank lines, no last "
    "newline") {
    const Workplace folder;
    const std::string hit = "0,hit,2,1,,,1\n";
    for (const char* rays :
         {"ox,oy,oz,dx,dy,dz\n1.5,1,-6,0,0,-1", "ox,oy,oz,dx,dy,dz\n0x1.8p0,0x1P+0,-0X6,0,-0,-0x10p-4\n",
          "ox,oy,oz,dx,dy,dz\r\n1.5,1,-6,0,0,-1\r\n", "ox,oy,oz,dx,dy,dz\r1.5,1,-6,0,0,-1\r",
          "\xef\xbb\xbfox,oy,oz,dx,dy,dz\n1.5,1,-6,0,0,-1\n", "ox, oy, oz, dx, dy, dz\n 1.5 ,\t1 , -6, 0, 0, -1 \n",
          "ox,oy,oz,dx,dy,dz\n\n  \n1.5,1,-6,0,0,-1\n\n\n", "ox,oy,oz,dx,dy,dz\n+1.5,+1e0,-600e-2,.0,0.,-1\n",
          "ox,oy,oz,dx,dy,dz\n1.5,1,-6,1e-999,0,-1\n"})
        CHECK_MESSAGE(folder.shoot(rays) == hit, rays);
}

TEST_CASE("t reads back as the number that was computed, in each scalar") {
    const Workplace folder;
    const std::string rays = std::string(rays_header) + "1.5,1,0,0,0,-3\n";  // t = 5/3
    write(folder / "r.csv", rays);
    const auto hits = [&](const char* scalar) {
        return run_glassbox({"shoot", "s.toml", "--rays", "r.csv", "--scalar", scalar}, {.folder = folder.path}).out;
    };
    CHECK(hits("float") == std::string(hits_header) + "0,hit,1,1.6666666,,,2\n");  // the float nearest to it
    CHECK(hits("double") == std::string(hits_header) + "0,hit,1,1.6666666666666667,,,2\n");
}

TEST_CASE("from stdin, into a file, and at the end of what stdout holds already") {
    const Workplace folder;
    const std::string rays = write(folder / "r.csv", std::string(rays_header) + "9,9,9,0,0,-1\n").string();
    // The default scalar is certified: a miss is proven, too, and far from the square bounds are enough for that.
    const std::string miss = std::string(hits_header) + "0,miss,,,,filter,0\n";
    const Arguments from_stdin{"shoot", "s.toml", "--rays", "/dev/stdin"};
    CHECK(run_glassbox(from_stdin, {.folder = folder.path, .in = rays.c_str()}).out == miss);
    for (const char* out : {"--out", "-o"}) {
        const Ran ran = run_glassbox({"shoot", "s.toml", "--rays", "r.csv", out, "h.csv"}, {.folder = folder.path});
        CHECK(ran.status == 0);
        CHECK(ran.out + ran.err == "");
        CHECK(content(folder / "h.csv") == miss);
    }
    const std::string log = write(folder / "log", "kept\n").string();
    CHECK(run_glassbox({"shoot", "s.toml", "--rays", "r.csv"}, {.folder = folder.path, .out = log.c_str()}).status ==
          0);
    CHECK(content(log) == "kept\n" + miss);
}

TEST_CASE("options that are about pictures, or come with a later stage, are noted in one line") {
    const Workplace folder;
    write(folder / "r.csv", std::string(rays_header) + "0,0,10,0,0,-1\n");
    const Ran ran = run_glassbox({"shoot", "s.toml", "--rays", "r.csv", "--scalar", "double", "--stage", "2", "--turn",
                                  "z:10", "--triangle", "tolerance", "--sphere", "textbook"},
                                 {.folder = folder.path});
    CHECK(ran.status == 0);
    CHECK(ran.out == std::string(hits_header) + "0,hit,0,9,,,1\n");
    CHECK(ran.err == "glassbox shoot: note: not used: --triangle (from stage 3), --turn (only for pictures)\n");
}
