#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <string>
#include <thread>
#include <vector>

#include "cli/commands.hpp"
#include "engine/vector_check.hpp"
#include "learn/subprocess/isolation.hpp"
#include "render/assumptions.hpp"
#include "scene/printable.hpp"
#include "scene/scene_path.hpp"

namespace glassbox {

namespace {

struct Finding {
    bool good;
    std::string what;
    std::string remedy;
};

std::vector<Finding> arithmetic() {
    std::vector<Finding> findings;
    for (const auto& [what, not_in, remedy] : try_assumptions_in_threads())
        findings.push_back({not_in.empty(), what, fmt::format("not in {}; {}", not_in, remedy)});
    for (const auto& [name, is_right] : engine::try_vectors())
        findings.push_back({is_right, fmt::format("{} vectors compute the same bits as one number at a time", name),
                            "they do not; use --engine plain, and report it"});
    return findings;
}

std::vector<Finding> surroundings() {
    const std::filesystem::path scenes = shipped_scenes();
    const std::string not_isolated = learn::why_not_isolated();
    const bool display = std::getenv("DISPLAY") != nullptr || std::getenv("WAYLAND_DISPLAY") != nullptr;
    return {
        {!scenes.empty(), scenes.empty() ? "its own scenes" : "its own scenes are in " + printable(scenes.string()),
         "not found; install it with cmake --install, or keep the source folder where it was built"},
        {true, fmt::format("{} threads", std::max(1u, std::thread::hardware_concurrency())), ""},
        {true,
         not_isolated.empty() ? "what learners hand in can run isolated"
                              : "what learners hand in would run with your rights: " + not_isolated,
         ""},
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
            fmt::print("  {:<5} {}{}\n", good ? "ok" : "BAD", what, good ? "" : ": " + remedy);
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
