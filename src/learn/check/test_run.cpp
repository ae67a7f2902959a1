#include "learn/check/test_run.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <fstream>
#include <future>
#include <iterator>
#include <random>
#include <system_error>
#include <thread>

#include "learn/build/headers.hpp"
#include "learn/check/seen_variables.hpp"
#include "learn/check/test_report.hpp"
#include "scene/text_file.hpp"

namespace glassbox::learn {
namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t memory_of_a_test = std::uint64_t{1} << 30;

/// The scalars that the tests are compiled for, each by itself. What is right in double and float is hardly ever wrong
/// in long double.
constexpr std::array<std::string_view, 3> scalars{"double", "float", "long double"};

std::string random_text() {
    std::random_device device;
    return fmt::format("{:08x}{:08x}", device(), device());
}

/// While this lives, nobody else makes or runs programs in that folder: another terminal may be watching, too.
class Lock {
public:
    Lock(const fs::path& folder, const std::stop_token& stop)
        : descriptor_(::open((folder / "lock").c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666)) {
        if (descriptor_ < 0)
            throw error_at({folder.string()},
                           fmt::format("cannot write in this folder: {}; name another one with --folder",
                                       std::generic_category().message(errno)));
        while (::flock(descriptor_, LOCK_EX | LOCK_NB) != 0 && !stop.stop_requested())
            std::this_thread::sleep_for(std::chrono::milliseconds(20));
    }
    Lock(const Lock&) = delete;
    Lock& operator=(const Lock&) = delete;
    ~Lock() { ::close(descriptor_); }

private:
    int descriptor_;
};

/// The result of one scalar's program.
struct Tried {
    std::optional<CompileError> error;  ///< why there is none
    Report report;
};

/// One scalar's program: compiled, linked, run.
class Program {
public:
    Program(const Workspace& workspace, const Exercise& exercise, const Toolchain& tools, const TestRequest& request,
            std::string_view scalar)
        : workspace_(workspace), exercise_(exercise), tools_(tools), request_(request), scalar_(scalar) {}

    std::string scalar() const { return std::string(scalar_); }

    /// Returns the tests' sources to compile for this scalar. Those that do not use the scalars are compiled only once.
    std::vector<fs::path> sources() const {
        std::vector<fs::path> sources;
        for (const std::string& test : exercise_.tests) {
            const fs::path source = workspace_.root / test;
            if (scalar_ == scalars.front() || read_text(source).find("EVERY_SCALAR") != std::string::npos)
                sources.push_back(source);
        }
        return sources;
    }

    /// Compiles and links, unless nothing has changed. Returns what went wrong, if anything did. `ingredients` is a
    /// fingerprint of what the program is made of.
    std::optional<CompileError> build(const std::string& ingredients, const std::stop_token& stop) {
        const std::vector<fs::path> all = sources();
        if (content_of(file("key")) == ingredients) return {};
        std::error_code none;
        fs::remove(file("key"), none);
        std::vector<fs::path> objects = tools_.runner;
        for (const fs::path& source : all) {
            objects.push_back(file(source.stem().string() + ".o"));
            const fs::path seen = file(source.filename().string());
            std::ofstream(seen, std::ios::binary) << with_seen_variables(read_text(source), source.string());
            std::optional<CompileError> error = compiled(seen, objects.back(), stop);
            // A test may be written in a way that our copy does not understand.
            if (error && !error->yours && !stop.stop_requested()) error = compiled(source, objects.back(), stop);
            if (error) return error;
        }
        if (auto error = link_error(link(tools_.compiler, objects, file("program"), tools_.linker, stop))) return error;
        std::ofstream(file("key"), std::ios::binary) << ingredients;
        return {};
    }

    /// Builds it and runs it.
    Tried test(const std::string& ingredients, const std::stop_token& stop) {
        Tried tried{build(ingredients, stop), {}};
        if (!tried.error && !stop.stop_requested()) tried.report = run(stop);
        return tried;
    }

private:
    /// Compiles one of the tests' sources. Returns what went wrong, if anything did.
    std::optional<CompileError> compiled(const fs::path& source, const fs::path& object,
                                         const std::stop_token& stop) const {
        Compilation what{source, object, includes_of(workspace_, exercise_, request_.headers), tools_.flags,
                         workspace_.root};
        for (const fs::path& more : {workspace_.root / "tests/stages", workspace_.root / "tests", doctest_folder()})
            what.includes.push_back(more);
        what.flags.push_back(fmt::format("-DEVERY_SCALAR={}", scalar_));
        const Outcome outcome = compile(tools_.compiler, what, stop);
        return compile_error(outcome, own_headers(exercise_, request_.headers), workspace_.root);
    }

    /// Runs in a folder of its own, so that it can harm no program and no object file.
    Report run(const std::stop_token& stop) const {
        const std::string nonce = random_text();
        const fs::path report = new_folder(file("run")) / fmt::format("{}-report", scalar_);
        Command command{file("program"), {report.string(), nonce}};
        command.folder = report.parent_path();
        command.limits = {.time = request_.deadline, .memory = memory_of_a_test, .file = std::uint64_t{16} << 20};
        if (tools_.compiler.isolation) command.isolation = Isolation{{request_.folder}, {command.folder}};
        const Outcome outcome = learn::run(command, stop);
        if (outcome.last_words.kind == LastWords::cannot_write) check_room(command.folder);
        return read_report(content_of(report), nonce, outcome);
    }

    fs::path file(const std::string& what) const { return request_.folder / fmt::format("{}-{}", scalar_, what); }

    const Workspace& workspace_;
    const Exercise& exercise_;
    const Toolchain& tools_;
    const TestRequest& request_;
    std::string_view scalar_;
};

/// A fingerprint of all that goes into a lesson's test programs.
std::string ingredients_of(const Workspace& workspace, const Exercise& exercise, const Toolchain& tools,
                           const fs::path& headers) {
    std::vector<std::string> parts{tools.identity};
    for (const char* folder : {"src/core", "tests/stages", "tests/support"})
        add_headers(parts, workspace.root / folder);
    for (const std::string& test : exercise.tests) parts.push_back(read_text(workspace.root / test));
    add_headers(parts, headers);
    parts.push_back(content_of(workspace.root / "lessons/not_written.hpp"));
    return fingerprint(parts);
}

/// Returns what went wrong when a scalar's program was built with our headers, if anything did.
std::optional<CompileError> error_with_ours(const Workspace& workspace, const Exercise& exercise,
                                            const Toolchain& tools, const fs::path& folder, std::string_view scalar,
                                            const std::stop_token& stop) {
    const TestRequest ours{workspace.solutions_of(exercise), make_folder(folder)};
    return Program(workspace, exercise, tools, ours, scalar)
        .build(ingredients_of(workspace, exercise, tools, ours.headers), stop);
}

/// Adds what a program reported. Cases without a scalar are in all programs; the first result is kept.
void add(TestRun& run, Report report) {
    const auto is_known = [&](const CheckMade& made) {
        return std::any_of(run.cases.begin(), run.cases.end(),
                           [&](const CaseResult& one) { return one.name == made.test; });
    };
    std::erase_if(report.checks, is_known);
    run.checks.insert(run.checks.end(), std::make_move_iterator(report.checks.begin()),
                      std::make_move_iterator(report.checks.end()));
    for (CaseResult& one : report.cases) {
        const auto same = std::find_if(run.cases.begin(), run.cases.end(),
                                       [&](const CaseResult& other) { return other.name == one.name; });
        if (same == run.cases.end()) run.cases.push_back(std::move(one));
    }
    if (run.disturbed.empty()) run.disturbed = std::move(report.disturbed);
}

}  // namespace

std::string function_not_written(const std::string& threw) {
    const std::size_t end = threw.find("` is not written yet (");
    return threw.starts_with('`') && end != std::string::npos ? threw.substr(1, end - 1) : "";
}

std::string Failure::not_written() const { return function_not_written(threw); }

std::pair<std::string_view, std::string_view> name_and_scalar(std::string_view test) {
    for (const std::string_view scalar : {"double", "float", "long double"})
        if (const std::string suffix = fmt::format("<{}>", scalar); test.ends_with(suffix))
            return {test.substr(0, test.size() - suffix.size()), scalar};
    return {test, ""};
}

bool TestRun::passed() const {
    const auto passes = [](const CaseResult& one) { return !one.failure; };
    return !error && disturbed.empty() && !stopped && !cases.empty() && std::all_of(cases.begin(), cases.end(), passes);
}

std::vector<fs::path> includes_of(const Workspace& workspace, const Exercise& exercise, const fs::path& headers) {
    std::vector<fs::path> includes{headers, workspace.root / "lessons"};
    std::vector<fs::path> stages;
    std::error_code none;
    for (const fs::directory_entry& entry : fs::directory_iterator(workspace.root / "src/core", none)) {
        const std::string name = entry.path().filename().string();
        if (entry.is_directory(none) && name[0] >= '1' && name[0] - '0' <= exercise.number)
            stages.push_back(entry.path());
    }
    std::sort(stages.begin(), stages.end());
    includes.insert(includes.end(), stages.begin(), stages.end());
    return includes;
}

OwnHeaders own_headers(const Exercise& exercise, const fs::path& headers) {
    OwnHeaders own{{headers}};
    for (const std::string& name : exercise.headers) own.included.push_back(headers / name);
    return own;
}

TestRun run_tests(const Workspace& workspace, const Exercise& exercise, const Toolchain& tools,
                  const TestRequest& request, const std::stop_token& stop) {
    const Lock lock(request.folder, stop);
    const std::string ingredients = ingredients_of(workspace, exercise, tools, request.headers);
    std::vector<Program> programs;
    for (const std::string_view scalar : scalars) {
        programs.emplace_back(workspace, exercise, tools, request, scalar);
        if (programs.back().sources().empty()) programs.pop_back();
    }
    std::stop_source enough;  // stops the others when one fails
    const std::stop_callback both(stop, [&] { enough.request_stop(); });
    std::vector<std::future<Tried>> tries;
    const auto try_next = [&] {
        Program& program = programs[tries.size()];
        tries.push_back(std::async(request.at_once ? std::launch::async : std::launch::deferred,
                                   [&] { return program.test(ingredients, enough.get_token()); }));
    };

    TestRun run;
    const std::size_t at_a_time = std::max(2u, std::thread::hardware_concurrency());
    const std::size_t always = request.double_first ? 1 : 2;  // whatever the others say
    for (std::size_t i = 0; i < programs.size() && (i < always || run.passed()); ++i) {
        while (tries.size() < std::min(i + at_a_time, programs.size())) try_next();
        const bool is_done = tries[i].wait_for(std::chrono::seconds(0)) != std::future_status::timeout;
        if (i > 0 && i + 1 == programs.size() && !is_done && request.so_far) request.so_far(run);
        Tried tried = tries[i].get();
        if (stop.stop_requested()) break;
        if (tried.error) {
            run.error = with_its_cause(*tried.error, [&] {
                return error_with_ours(workspace, exercise, tools, request.folder / "ours", programs[i].scalar(), stop);
            });
            break;
        }
        add(run, std::move(tried.report));
        run.scalars.push_back(programs[i].scalar());
    }
    enough.request_stop();
    run.stopped = stop.stop_requested();
    if (run.error) run.cases.clear();
    return run;
}

}  // namespace glassbox::learn
