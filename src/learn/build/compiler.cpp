#include "learn/build/compiler.hpp"

#include <fmt/format.h>

#include <cstdlib>
#include <iterator>

#include "learn/build/compile_error.hpp"
#include "learn/subprocess/subprocess.hpp"
#include "scene/error.hpp"
#include "scene/text_file.hpp"

namespace glassbox::learn {
namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;

constexpr Limits while_compiling{.time = 120s, .memory = std::uint64_t{2} << 30, .output = std::size_t{1} << 20};

/// Messages in English, whatever the learner's language, because we parse them; and no compiler cache, which only costs
/// time for files that change each time.
const std::vector<std::pair<std::string, std::string>> plain{
    {"LC_ALL", "C"}, {"CCACHE_DISABLE", "1"}, {"GCC_COLORS", ""}, {"CLICOLOR_FORCE", ""}};

Outcome run_compiler(const Compiler& compiler, std::vector<std::string> arguments, const fs::path& folder,
                     const std::stop_token& stop, const Isolation& files = {}) {
    Command command{compiler.program, std::move(arguments), plain, folder, while_compiling};
    if (compiler.isolation) {
        command.isolation = compiler.isolation;
        Isolation& all = *command.isolation;
        all.reads.insert(all.reads.end(), files.reads.begin(), files.reads.end());
        all.writes.insert(all.writes.end(), files.writes.begin(), files.writes.end());
    }
    return run(command, stop);
}

/// The folder of a compiler that is not one of the system's: the one that contains its bin, unless that is the home
/// folder.
fs::path own_folder(const std::string& program) {
    std::error_code none;
    const fs::path file = fs::canonical(program, none), folder = file.parent_path().parent_path();
    const char* home = std::getenv("HOME");
    const bool is_home = home && *home && !fs::relative(home, folder, none).string().starts_with("..");
    return none || file.parent_path().filename() != "bin" || folder == "/" || is_home ? fs::path() : folder;
}

/// Returns the path relative to the folder, if it lies in it.
std::string named_from(const fs::path& folder, const fs::path& path) {
    const fs::path near = path.lexically_relative(folder);
    return folder.empty() || near.empty() || *near.begin() == ".." ? path.string() : near.string();
}

std::vector<std::string> arguments_of(const Compilation& what) {
    std::vector<std::string> arguments{"-std=c++20", "-ffp-contract=off"};
    for (const fs::path& include : what.includes) arguments.push_back("-I" + named_from(what.folder, include));
    arguments.insert(arguments.end(), what.flags.begin(), what.flags.end());
    return arguments;
}

}  // namespace

Compiler find_compiler() {
    const char* chosen = std::getenv("CXX");
    Compiler compiler;
    compiler.program = chosen && *chosen ? chosen : GLASSBOX_CXX;
    const Outcome version = run_compiler(compiler, {"--version"}, {}, {});
    if (!version.well())
        throw Error(
            fmt::format("glassbox learn: error: the compiler {} does not answer: {}; install g++ (Debian, Ubuntu: sudo "
                        "apt-get install "
                        "g++), or name yours: CXX=clang++ ./glassbox learn",
                        in_quotes(compiler.program), how_it_ended(version)));
    compiler.identity = version.output;
    compiler.clang = version.output.find("clang") != std::string::npos;
    return compiler;
}

Compiler isolated(Compiler compiler, std::vector<fs::path> reads) {
    if (const fs::path own = own_folder(compiler.program); !own.empty()) reads.push_back(own);
    compiler.isolation = Isolation{std::move(reads), {}};
    const Outcome version = run_compiler(compiler, {"--version"}, {}, {});
    if (!version.well())
        throw Error(
            fmt::format("glassbox learn: error: the compiler {} does not answer when it runs isolated: {}; "
                        "use one of the system's: CXX=g++ ./glassbox learn",
                        in_quotes(compiler.program), how_it_ended(version)));
    return compiler;
}

Outcome compile(const Compiler& compiler, const Compilation& what, const std::stop_token& stop) {
    std::vector<std::string> arguments = arguments_of(what);
    const std::string source = named_from(what.folder, what.source);
    arguments.insert(arguments.end(), {compiler.clang ? "-ferror-limit=20" : "-fmax-errors=20", "-c",
                                       named_from(what.folder, what.source), "-o", what.object.string()});
    return run_compiler(compiler, std::move(arguments), what.folder, stop,
                        {what.includes, {what.object.parent_path()}});
}

Outcome link(const Compiler& compiler, const std::vector<fs::path>& objects, const fs::path& program,
             const std::string& linker, const std::stop_token& stop) {
    std::vector<std::string> arguments{"-o", program.string()};
    if (!linker.empty()) arguments.push_back(linker);
    Isolation files{{}, {program.parent_path()}};
    for (const fs::path& object : objects) {
        arguments.push_back(object.string());
        files.reads.push_back(object.parent_path());
    }
    return run_compiler(compiler, std::move(arguments), {}, stop, files);
}

void precompile(const Compiler& compiler, const Compilation& header, const std::stop_token& stop) {
    std::vector<std::string> arguments = arguments_of(header);
    arguments.insert(arguments.end(), {"-x", "c++-header", header.source.string(), "-o", header.object.string()});
    const Outcome outcome = run_compiler(compiler, std::move(arguments), header.folder, stop);
    if (!outcome.well()) throw error_in_ours(outcome, header.source);
}

std::vector<std::string> beginning_with(const Compiler& compiler, const fs::path& precompiled) {
    if (compiler.clang) return {"-include-pch", precompiled.string()};
    // g++ is given the header's name, and looks for the same name with .gch at its end first.
    return {"-include", fs::path(precompiled).replace_extension().string()};
}

fs::path doctest_folder() {
    if (*GLASSBOX_DOCTEST == '\0')
        throw Error(
            "glassbox learn: error: the tests need doctest, and this program was built without it; install it (Debian, "
            "Ubuntu: sudo apt-get install doctest-dev) and build again with the tests: cmake -D GLASSBOX_TESTS=ALL");
    return GLASSBOX_DOCTEST;
}

std::string fingerprint(const std::vector<std::string>& parts) {
    // FNV-1a, 64 bits: not a cryptographic hash.
    std::uint64_t hash = 14695981039346656037u;
    const auto take = [&](unsigned char byte) { hash = (hash ^ byte) * 1099511628211u; };
    for (const std::string& part : parts) {
        for (const char byte : part) take(static_cast<unsigned char>(byte));
        take('\0');
    }
    return fmt::format("{:016x}", hash);
}

}  // namespace glassbox::learn
