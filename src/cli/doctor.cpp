#include <fmt/format.h>

#include <cfenv>
#include <cfloat>
#include <cmath>
#include <cstdlib>
#include <string>
#include <thread>
#include <vector>

#include "cli/commands.hpp"
#include "cli/scene_path.hpp"
#include "scene/printable.hpp"

namespace glassbox {

namespace {

struct Finding {
    bool good;
    std::string what;
    std::string remedy;
};

/// a·b − c·d as the machine really computes it; volatile keeps the compiler from doing so beforehand.
double difference_of_products(double a, double b, double c, double d) {
    volatile double x = a, y = b, z = c, w = d;
    return x * y - z * w;
}

std::vector<Finding> arithmetic() {
    const double tenth = 0.1, third = 1.0 / 3;
    const bool uncontracted = difference_of_products(tenth, third, tenth, third) == 0;
    volatile double smallest = DBL_MIN;
    const bool gradual = smallest / 2 > 0;
    const std::string rebuild = "rebuild with the project's own CMakeLists.txt, without extra compiler flags";
    return {
        {uncontracted, "a·b − c·d is rounded as written, not contracted", rebuild + " (it sets -ffp-contract=off)"},
        {FLT_EVAL_METHOD == 0, "each operation is rounded to its own type", "build for a machine with SSE2"},
        {std::fegetround() == FE_TONEAREST, "rounding is to nearest", "run it without changing the rounding mode"},
        {gradual, "numbers below 2^-1022 are kept", rebuild + " (-ffast-math switches them off)"},
    };
}

std::vector<Finding> surroundings() {
    const std::filesystem::path scenes = shipped_scenes();
    const bool display = std::getenv("DISPLAY") != nullptr || std::getenv("WAYLAND_DISPLAY") != nullptr;
    return {
        {!scenes.empty(), scenes.empty() ? "its own scenes" : "its own scenes are in " + printable(scenes.string()),
         "install it with cmake --install, or keep the source folder where it was built"},
        {true, fmt::format("{} threads", std::max(1u, std::thread::hardware_concurrency())), ""},
        {true, display ? "there is a display" : "there is no display; render, measure and shoot need none", ""},
    };
}

int examine() {
#ifdef __clang__
    const std::string compiler = fmt::format("clang++ {}", __clang_version__);
#else
    const std::string compiler = fmt::format("g++ {}", __VERSION__);
#endif
    fmt::print("glassbox {}, built with {}\n", GLASSBOX_VERSION, compiler);
    int bad = 0;
    const auto report = [&](const std::string& title, const std::vector<Finding>& findings) {
        fmt::print("\n{}\n", title);
        for (const auto& [good, what, remedy] : findings) {
            fmt::print("  {:<5} {}{}\n", good ? "ok" : "BAD", what, good ? "" : ": it is not so; " + remedy);
            bad += good ? 0 : 1;
        }
    };
    report("Arithmetic, on which every bound rests", arithmetic());
    report("What it found here", surroundings());
    fmt::print("\n{}\n", bad == 0 ? "All is well." : fmt::format("{} not as it should be: see BAD above.", bad));
    return bad == 0 ? 0 : 1;
}

}  // namespace

void add_doctor(CLI::App& program) {
    program.add_subcommand("doctor", "Look at this machine and this build, and say what is wrong")->callback([] {
        if (const int status = examine(); status != 0) throw CLI::RuntimeError(status);
    });
}

}  // namespace glassbox
