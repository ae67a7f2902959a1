#include "learn/subprocess/isolation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "learn/subprocess/subprocess.hpp"

namespace glassbox::learn {
namespace {

namespace fs = std::filesystem;

/// What compilers and programs need of the system, where it exists. None of it is secret.
constexpr std::array system_files{"/usr",
                                  "/bin",
                                  "/sbin",
                                  "/lib",
                                  "/lib32",
                                  "/lib64",
                                  "/libx32",
                                  "/etc/alternatives",
                                  "/etc/ld.so.cache",
                                  "/etc/ld.so.conf",
                                  "/etc/ld.so.conf.d",
                                  "/etc/os-release",
                                  "/etc/debian_version",
                                  "/nix/store",
                                  "/gnu/store"};

}  // namespace

std::vector<std::string> isolating_command(const Isolation& isolation, const fs::path& folder) {
    std::vector<std::string> words{
        "bwrap", "--unshare-all", "--die-with-parent", "--new-session", "--cap-drop", "ALL", "--proc", "/proc",
        "--dev", "/dev",          "--tmpfs",           "/tmp"};
    for (const char* path : system_files) words.insert(words.end(), {"--ro-bind-try", path, path});
    std::vector<std::pair<fs::path, const char*>> seen;
    for (const fs::path& path : isolation.reads) seen.emplace_back(path.lexically_normal(), "--ro-bind-try");
    for (const fs::path& path : isolation.writes) seen.emplace_back(path.lexically_normal(), "--bind");
    // A folder comes before what lies in it, because a later mount hides what is there.
    std::stable_sort(seen.begin(), seen.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    for (const auto& [path, how] : seen) words.insert(words.end(), {how, path.string(), path.string()});
    words.insert(words.end(), {"--remount-ro", "/"});
    if (!folder.empty()) words.insert(words.end(), {"--chdir", folder.string()});
    words.push_back("--");
    return words;
}

bool is_for_isolated(std::string_view variable) {
    return variable == "PATH" || variable == "LANG" || variable == "TZ" || variable.starts_with("LC_");
}

std::vector<std::pair<std::string, std::string>> environment_of_isolated() { return {{"HOME", "/tmp"}}; }

std::string why_not_isolated() {
    Command nothing{"true", {}};
    nothing.isolation = Isolation{};
    const Outcome outcome = run(nothing);
    if (outcome.well()) return "";
    if (outcome.end == End::not_started)
        return "bubblewrap is not there; install it (Debian, Ubuntu: sudo apt-get install bubblewrap; Fedora: sudo dnf "
               "install bubblewrap; Arch: sudo pacman -S bubblewrap)";
    return fmt::format("bubblewrap cannot set a program apart here ({}); allow user namespaces, or use another machine",
                       how_it_ended(outcome));
}

}  // namespace glassbox::learn
