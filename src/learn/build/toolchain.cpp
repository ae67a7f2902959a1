#include "learn/build/toolchain.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <array>
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

void remove_old(const fs::path& hidden, const fs::path& but) {
    std::vector<std::pair<fs::file_time_type, fs::path>> found;
    std::error_code none;
    for (const fs::directory_entry& entry : fs::directory_iterator(hidden, none))
        if (entry.path().filename().string().starts_with("tools-") && entry.path() != but)
            found.emplace_back(entry.last_write_time(none), entry.path());
    std::sort(found.rbegin(), found.rend());
    for (std::size_t i = most_kept - 1; i < found.size(); ++i) fs::remove_all(found[i].second, none);
}

void make(const Workspace& workspace, const Compiler& compiler, const fs::path& doctest, const fs::path& folder,
          const std::string& precompiled) {
    const fs::path runner = workspace.root / "src/learn/check/runner";
    const std::vector<fs::path> includes{workspace.root / "tests", workspace.root / "src", doctest};
    const auto compile_main = [&](const char* name) {
        const Compilation what{
            runner / fmt::format("{}.cpp", name), folder / fmt::format("{}.o", name), includes, {"-O1", "-g0"}, {}};
        const Outcome outcome = compile(compiler, what);
        if (!outcome.well()) throw error_in_ours(outcome, what.source);
    };
    auto both = std::async(std::launch::async, [&] {
        compile_main("main");
        compile_main("picture");
    });
    precompile(compiler, {runner / "prelude.hpp", folder / precompiled, includes, test_flags, {}});
    both.get();
}

}  // namespace

Toolchain toolchain(const Workspace& workspace, const std::function<void(const std::string&)>& say) {
    Toolchain tools;
    tools.compiler = find_compiler();
    const fs::path doctest = doctest_folder();
    std::vector<std::string> parts{tools.compiler.program, tools.compiler.identity, state_of(doctest / "doctest.h")};
    parts.insert(parts.end(), test_flags.begin(), test_flags.end());
    for (const char* file : {"src/learn/check/runner/prelude.hpp", "src/learn/check/runner/main.cpp",
                             "src/learn/check/runner/picture.cpp", "src/learn/subprocess/last_words.hpp",
                             "tests/support/ulps.hpp", "tests/support/traced_ray.hpp", "tests/support/seen.hpp"})
        parts.push_back(read_text(workspace.root / file));
    parts.push_back(workspace.root.string());  // clang++ records where its headers were
    tools.identity = fingerprint(parts);

    const fs::path folder = workspace.hidden() / ("tools-" + tools.identity);
    const std::string precompiled = tools.compiler.clang ? "prelude.pch" : "prelude.hpp.gch";
    tools.main = folder / "main.o";
    tools.picture_main = folder / "picture.o";
    tools.prelude = folder / precompiled;
    tools.flags = test_flags;
    for (const std::string& flag : beginning_with(tools.compiler, tools.prelude)) tools.flags.push_back(flag);
    if (is_there(tools)) return tools;

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
    return tools;
}

bool is_there(const Toolchain& tools) {
    std::error_code none;
    return std::ranges::all_of(std::array{tools.main, tools.picture_main, tools.prelude},
                               [&](const fs::path& file) { return fs::is_regular_file(file, none); });
}

Toolchain isolated(Toolchain tools, const Workspace& workspace) {
    const std::string why_not = why_not_isolated();
    if (!why_not.empty()) throw Error("glassbox learn: error: " + why_not);
    std::vector<fs::path> reads{tools.main.parent_path(), doctest_folder()};
    for (const char* folder : {"src", "tests", "lessons"}) reads.push_back(workspace.root / folder);
    tools.compiler = isolated(std::move(tools.compiler), std::move(reads));
    return tools;
}

}  // namespace glassbox::learn
