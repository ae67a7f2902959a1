#include "learn/build/toolchain.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <future>

#include "learn/build/compile_error.hpp"
#include "learn/build/headers.hpp"
#include "scene/text_file.hpp"

namespace glassbox::learn {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t most_kept = 3;  // toolchains; each takes some tens of megabytes

/// -O0 compiles fastest; a function without a return would only crash, so it is an error. With assertions a program
/// that reads beyond the end of a vector, or a hit where there is none, ends: without, its tests might pass.
const std::vector<std::string> test_flags{"-O0", "-g0", "-D_GLIBCXX_ASSERTIONS", "-Werror=return-type"};

/// What is compiled once: the tests' main() with what they share, and the main() of a lesson's program.
const std::string prelude_source = "src/learn/check/runner/prelude.hpp";
const std::string picture_source = "src/learn/check/runner/picture.cpp";
const std::vector<std::string> runner_sources{"src/learn/check/runner/main.cpp", "tests/support/random_bits.cpp",
                                              "tests/support/seen.cpp", "tests/support/ulps.cpp"};

constexpr const char* linker_file = "linker";

fs::path object_of(const fs::path& folder, const fs::path& source) { return folder / (source.stem().string() + ".o"); }

void remove_old(const fs::path& hidden, const fs::path& but) {
    std::vector<std::pair<fs::file_time_type, fs::path>> found;
    std::error_code none;
    for (const fs::directory_entry& entry : fs::directory_iterator(hidden, none))
        if (entry.path().filename().string().starts_with("tools-") && entry.path() != but)
            found.emplace_back(entry.last_write_time(none), entry.path());
    std::sort(found.rbegin(), found.rend());
    for (std::size_t i = most_kept - 1; i < found.size(); ++i) fs::remove_all(found[i].second, none);
}

/// Links a program without tests by each, and returns the flag of the first that can.
std::string fastest_linker(const Compiler& compiler, const fs::path& folder) {
    std::vector<fs::path> objects;
    for (const std::string& source : runner_sources) objects.push_back(object_of(folder, source));
    const fs::path program = folder / "no-tests";
    std::string fastest;
    for (const char* linker : {"-fuse-ld=gold", "-fuse-ld=lld"})
        if (fastest.empty() && link(compiler, objects, program, linker).well()) fastest = linker;
    std::error_code none;
    fs::remove(program, none);
    return fastest;
}

void make(const Workspace& workspace, const Compiler& compiler, const fs::path& doctest, const fs::path& folder,
          const std::string& precompiled) {
    const std::vector<fs::path> includes{workspace.root / "tests", workspace.root / "src", doctest};
    const auto compile_once = [&](const std::string& source) {
        const Compilation what{workspace.root / source, object_of(folder, source), includes, {"-O1", "-g0"}, {}};
        const Outcome outcome = compile(compiler, what);
        if (!outcome.well()) throw error_in_ours(outcome, what.source);
    };
    auto objects = std::async(std::launch::async, [&] {
        for (const std::string& source : runner_sources) compile_once(source);
        compile_once(picture_source);
    });
    precompile(compiler, {workspace.root / prelude_source, folder / precompiled, includes, test_flags, {}});
    objects.get();
    std::ofstream(folder / linker_file, std::ios::binary) << fastest_linker(compiler, folder);
}

}  // namespace

Toolchain toolchain(const Workspace& workspace, const std::function<void(const std::string&)>& say) {
    Toolchain tools;
    tools.compiler = find_compiler();
    const fs::path doctest = doctest_folder();
    std::vector<std::string> parts{tools.compiler.program, tools.compiler.identity, state_of(doctest / "doctest.h")};
    parts.insert(parts.end(), test_flags.begin(), test_flags.end());
    for (const char* folder : {"src/learn/check/runner", "tests/support"}) add_headers(parts, workspace.root / folder);
    parts.push_back(read_text(workspace.root / "src/learn/subprocess/last_words.hpp"));
    for (const std::string& source : runner_sources) parts.push_back(read_text(workspace.root / source));
    parts.push_back(read_text(workspace.root / picture_source));
    parts.push_back(workspace.root.string());  // clang++ records where its headers were
    tools.identity = fingerprint(parts);

    const fs::path folder = workspace.hidden() / ("tools-" + tools.identity);
    const std::string precompiled = tools.compiler.clang ? "prelude.pch" : "prelude.hpp.gch";
    for (const std::string& source : runner_sources) tools.runner.push_back(object_of(folder, source));
    tools.picture_main = object_of(folder, picture_source);
    tools.prelude = folder / precompiled;
    tools.flags = test_flags;
    for (const std::string& flag : beginning_with(tools.compiler, tools.prelude)) tools.flags.push_back(flag);
    if (is_there(tools)) {
        tools.linker = content_of(folder / linker_file);
        return tools;
    }

    std::error_code failed;
    say("preparing the tests for your compiler: once, some seconds");
    // All or nothing: made under a temporary name first.
    const fs::path making = workspace.hidden() / fmt::format("new-tools-{}", ::getpid());
    fs::remove_all(making, failed);
    make_folder(making);
    try {
        make(workspace, tools.compiler, doctest, making, precompiled);
    } catch (...) {
        fs::remove_all(making, failed);
        throw;
    }
    fs::remove_all(folder, failed);  // an incomplete one
    fs::rename(making, folder, failed);
    if (failed) {
        const std::string why = failed.message();
        fs::remove_all(making, failed);
        if (!is_there(tools))  // else another process was faster
            throw error_at({folder.string()}, fmt::format("cannot make this folder: {}", why));
    }
    remove_old(workspace.hidden(), folder);
    tools.linker = content_of(folder / linker_file);
    return tools;
}

bool is_there(const Toolchain& tools) {
    std::error_code none;
    const auto is_file = [&](const fs::path& file) { return fs::is_regular_file(file, none); };
    return is_file(tools.picture_main) && is_file(tools.prelude) && std::ranges::all_of(tools.runner, is_file);
}

Toolchain isolated(Toolchain tools, const Workspace& workspace) {
    const std::string why_not = why_not_isolated();
    if (!why_not.empty()) throw Error("glassbox learn: error: " + why_not);
    std::vector<fs::path> reads{tools.prelude.parent_path(), doctest_folder()};
    for (const char* folder : {"src", "tests", "lessons"}) reads.push_back(workspace.root / folder);
    tools.compiler = isolated(std::move(tools.compiler), std::move(reads));
    return tools;
}

}  // namespace glassbox::learn
