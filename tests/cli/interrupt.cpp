// Ctrl-C and everything else that ends a program: it ends at once, with exit status 130 where it still can, and leaves
// its folder as it was.
#include <doctest.h>
#include <sys/resource.h>

#include "cli/program.hpp"

using namespace glassbox::test;
using std::chrono::milliseconds;
using namespace std::chrono_literals;

namespace {

/// Runs the program, sends the signal after each of these times, and checks that only the named files are left.
void check_interrupted(const Folder& folder, const Arguments& arguments, const std::vector<milliseconds>& times,
                       int signal = SIGINT) {
    const std::ptrdiff_t before = folder.entries();
    for (const milliseconds time : times) {
        CAPTURE(time.count());
        const Ran ran = run_glassbox(arguments, {.folder = folder.path, .signal_at = time, .signal = signal});
        CHECK(ran.status == 130);
        CHECK(ran.err.ends_with("glassbox: interrupted; no half-written file is left\n"));
        CHECK(ran.seconds < 4);  // 0.1 on an idle machine; uninterrupted, the work alone takes several times that
        CHECK(folder.entries() == before);
    }
}

/// A soft limit that programs started meanwhile inherit.
class Limit {
public:
    using Resource = decltype(RLIMIT_FSIZE);

    Limit(Resource resource, rlim_t value) : resource_(resource) {
        ::getrlimit(resource_, &before_);
        const rlimit low{value, before_.rlim_max};
        ::setrlimit(resource_, &low);
    }
    Limit(const Limit&) = delete;
    Limit& operator=(const Limit&) = delete;
    ~Limit() { ::setrlimit(resource_, &before_); }

private:
    Resource resource_;
    rlimit before_{};
};

}  // namespace

TEST_CASE("while tracing, whatever the signal: Ctrl-C, a polite kill, a terminal that was closed") {
    const Folder folder;
    write(folder / "o.png", "of an earlier run");
    const Arguments render{"render", "room", "--size", "8000x6000", "-o", "o.png"};
    check_interrupted(folder, render, {milliseconds(300), milliseconds(500)});
    for (const int signal : {SIGTERM, SIGHUP, SIGQUIT, SIGALRM, SIGUSR1, SIGUSR2})
        check_interrupted(folder, render, {milliseconds(300)}, signal);
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

TEST_CASE("killed while writing, when nothing can be said or done: not even then is half a file left") {
    const Folder folder;
    if (!can_make_nameless_files(folder.path)) return;
    write(folder / "s.toml", "");
    write(folder / "m.csv", "of an earlier run");
    // Some of these times fall into tracing, some into writing 12 million lines, which takes as long, on slow and fast
    // machines.
    const Arguments measure{"measure", "s.toml", "--what", "hits", "--size", "4000x3000", "-o", "m.csv"};
    for (const milliseconds time : {300ms, 600ms, 900ms, 1200ms, 1600ms, 2000ms}) {
        CAPTURE(time.count());
        const Ran ran = run_glassbox(measure, {.folder = folder.path, .signal_at = time, .signal = SIGKILL});
        CHECK(folder.entries() == 2);
        if (ran.status == 0) break;  // it had ended before the signal
        CHECK(ran.status == 128 + SIGKILL);
        CHECK(content(folder / "m.csv") == "of an earlier run");
    }
}

TEST_CASE("a limit on the size of files is an error of writing") {
    const Folder folder;
    write(folder / "s.toml", "");
    write(folder / "o.ppm", "of an earlier run");
    const Limit limit(RLIMIT_FSIZE, 20 * 512);  // ulimit -f 20; the picture has 300 * 200 * 3 bytes
    for (const char* out : {"o.ppm", "new.ppm"})
        check_refused(folder, {"render", "s.toml", "--size", "300x200", "-o", out}, 1,
                      {std::string(out) + ": error: cannot write: File too large; raise the limit", "(ulimit -f)"});
    const Ran printed =
        run_glassbox({"explain", "levental-2014", "--pixel", "350,149", "--json"}, {.folder = folder.path});
    CHECK(printed.status == 1);
    CHECK(printed.err ==
          "standard output: error: cannot write: File too large; raise the limit on the size of files (ulimit -f)\n");
}

TEST_CASE("the soft limit on processor time is said to be reached") {
    const Folder folder;
    const auto ours = std::signal(SIGXCPU, SIG_IGN);  // the limit covers this test's own time, too
    const Limit limit(RLIMIT_CPU, 1);
    const Ran ran = run_glassbox({"render", "room", "--size", "8000x6000", "-o", "o.png"}, {.folder = folder.path});
    CHECK(ran.status == 1);
    CHECK(ran.err.ends_with(
        "glassbox: error: the limit on processor time (ulimit -t) is reached; raise it, or ask for less; no "
        "half-written file is left\n"));
    CHECK(folder.entries() == 0);
    std::signal(SIGXCPU, ours);
}
