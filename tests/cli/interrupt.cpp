// Ctrl-C: the program ends at once with status 130, and leaves its folder as it was.
#include <doctest.h>

#include "cli/program.hpp"

using namespace glassbox::test;
using std::chrono::milliseconds;

namespace {

/// Runs that, sends the signal after each of these times, and checks that nothing is left but the files named.
void check_interrupted(const Folder& folder, const Arguments& arguments, const std::vector<milliseconds>& times,
                       int signal = SIGINT) {
    const std::ptrdiff_t before = folder.entries();
    for (const milliseconds time : times) {
        CAPTURE(time.count());
        const Ran ran = run_glassbox(arguments, {.folder = folder.path, .signal_at = time, .signal = signal});
        CHECK(ran.status == 130);
        CHECK(ran.err.ends_with("glassbox: interrupted; no half-written file is left\n"));
        CHECK(ran.seconds < 4);  // 0.1 where nothing else runs; else the work alone takes several times that
        CHECK(folder.entries() == before);
    }
}

}  // namespace

TEST_CASE("while tracing, whatever the signal: Ctrl-C, a polite kill, a terminal that was closed") {
    const Folder folder;
    write(folder / "o.png", "of an earlier run");
    const Arguments render{"render", "room", "--size", "8000x6000", "-o", "o.png"};
    check_interrupted(folder, render, {milliseconds(300), milliseconds(500)});
    check_interrupted(folder, render, {milliseconds(300)}, SIGTERM);
    check_interrupted(folder, render, {milliseconds(300)}, SIGHUP);
    const Arguments measure{"measure", "room", "--what", "depth,n.l", "--size", "4000x3000", "-o", "m.exr"};
    check_interrupted(folder, measure, {milliseconds(300)});
    CHECK(content(folder / "o.png") == "of an earlier run");
}

TEST_CASE("while encoding and writing: an empty picture is traced in no time, and takes seconds to compress") {
    const Folder folder;
    write(folder / "s.toml", "");
    const Arguments render{"render", "s.toml", "--stage", "1", "--size", "10000x8000", "-o", "o.png"};
    check_interrupted(folder, render, {milliseconds(300), milliseconds(1000)});
}

TEST_CASE("while reading a large file") {
    const Folder folder;
    std::string rays = "ox,oy,oz,dx,dy,dz\n";
    const std::string row = "123.45678901234567,-0.12345678901234567,1.2345678901234567e-5,0.1,0.2,0x1.8p-3\n";
    while (rays.size() < 150'000'000) rays += row;
    write(folder / "r.csv", rays);
    check_interrupted(folder, {"shoot", "room", "--rays", "r.csv", "--out", "h.csv"},
                      {milliseconds(200), milliseconds(400)});
}
