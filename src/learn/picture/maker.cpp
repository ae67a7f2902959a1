#include "learn/picture/maker.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <string_view>
#include <utility>
#include <variant>

#include "learn/build/compile_error.hpp"
#include "learn/build/headers.hpp"
#include "learn/check/test_run.hpp"
#include "learn/course/progress.hpp"
#include "learn/picture/drawing.hpp"
#include "render/job.hpp"
#include "render/option_names.hpp"
#include "scene/text_file.hpp"

namespace glassbox::learn::mine {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

/// -O0 compiles fastest, and leaves mistakes as they were written: an endless recursion does not become a loop, and a
/// null pointer is dereferenced. A function without a return would only crash, so it is an error.
const std::vector<std::string> flags{"-O0", "-g0", "-w", "-D_GLIBCXX_ASSERTIONS", "-Werror=return-type"};

double seconds_since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

/// Throws Error if a file of ours could not be made.
void check(const std::error_code& failed, const fs::path& path) {
    if (failed)
        throw error_at({path.string()},
                       fmt::format("cannot make this: {}; is there room, and may we write there?", failed.message()));
}

/// The present state of our own headers and sources, without reading them: a new version of Glassbox recompiles.
std::string state_of_ours(const fs::path& root) {
    std::vector<std::string> states;
    std::error_code none;
    for (const char* folder : {"src/core", "src/numerics", "src/scene", "src/render", "src/learn/picture"})
        for (const fs::directory_entry& entry : fs::recursive_directory_iterator(root / folder, none))
            if (entry.is_regular_file(none)) states.push_back(state_of(entry.path()));
    std::sort(states.begin(), states.end());
    return fingerprint(states);
}

/// The learner's headers come before ours; those of all other lessons are ours.
std::vector<fs::path> includes(const Workspace& workspace, const Exercise& exercise) {
    std::vector<fs::path> stages;
    std::error_code none;
    for (const fs::directory_entry& entry : fs::directory_iterator(workspace.root / "src/core", none))
        if (entry.is_directory(none)) stages.push_back(entry.path());
    std::sort(stages.begin(), stages.end());
    std::vector<fs::path> all{workspace.headers_of(exercise), workspace.root / "lessons"};
    all.insert(all.end(), stages.begin(), stages.end());
    all.push_back(workspace.root / "src");
    return all;
}

void remove_all_that_begin_with(std::string_view name, const fs::path& folder) {
    std::vector<fs::path> found;
    std::error_code none;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder, none))
        if (entry.path().filename().string().starts_with(name)) found.push_back(entry.path());
    for (const fs::path& path : found) fs::remove_all(path, none);
}

/// The folder of the learner's renderers and of the prelude that they include first. One compiler made all that is in
/// it.
struct Workshop {
    fs::path folder;
    std::string precompiled;
};

Workshop workshop(const Workspace& workspace, const Compiler& compiler, const std::stop_token& stop) {
    const fs::path prelude = workspace.root / "src/learn/picture/prelude.hpp";
    std::vector<std::string> parts{compiler.program, compiler.identity, workspace.root.string()};
    parts.insert(parts.end(), flags.begin(), flags.end());
    for (const fs::path& file : {prelude, workspace.root / "src/learn/picture/sheet.hpp",
                                 workspace.root / "src/learn/subprocess/last_words.hpp"})
        parts.push_back(read_text(file));
    const Workshop shop{workspace.hidden() / ("drawing-" + fingerprint(parts)),
                        compiler.clang ? "prelude.pch" : "prelude.hpp.gch"};
    std::error_code failed;
    if (fs::is_regular_file(shop.folder / shop.precompiled, failed)) return shop;

    // All or nothing: made under a temporary name first. Deletes what an older compiler or Glassbox has made.
    remove_all_that_begin_with("drawing-", workspace.hidden());
    const fs::path making = workspace.hidden() / fmt::format("new-drawing-{}", ::getpid());
    make_folder(making);
    try {
        precompile(compiler, {prelude, making / shop.precompiled, {workspace.root / "src"}, flags, workspace.root},
                   stop);
    } catch (...) {
        fs::remove_all(making, failed);
        if (stop.stop_requested()) throw Cancelled{};
        throw;
    }
    fs::rename(making, shop.folder, failed);
    if (failed) fs::remove_all(making, failed);  // another process was faster
    return shop;
}

/// A renderer, or why there is none.
struct Built {
    fs::path program;
    std::optional<CompileError> error;
    std::string words;
};

Built build(const Workspace& workspace, const Exercise& exercise, const Compiler& compiler, const Workshop& shop,
            const std::vector<std::string>& rules, const fs::path& program, const std::stop_token& stop) {
    std::vector<std::string> all = flags;
    all.insert(all.end(), rules.begin(), rules.end());
    for (const std::string& flag : beginning_with(compiler, shop.folder / shop.precompiled)) all.push_back(flag);
    const fs::path object = shop.folder / fmt::format("new-{}.o", ::getpid()),
                   made = shop.folder / fmt::format("new-{}", ::getpid());
    const Outcome compiled = compile(
        compiler,
        {workspace.root / "src/learn/picture/renderer.cpp", object, includes(workspace, exercise), all, workspace.root},
        stop);
    if (stop.stop_requested()) throw Cancelled{};
    Built built{program, compile_error(compiled, own_headers(exercise, workspace.headers_of(exercise)), workspace.root),
                ""};
    if (!built.error && !compiled.well()) built.words = "the compiler could not compile it: " + how_it_ended(compiled);
    if (!built.error && built.words.empty()) {
        const Outcome linked = link(compiler, {object}, made, stop);
        if (stop.stop_requested()) throw Cancelled{};
        built.error = link_error(linked);
        if (!built.error && !linked.well()) built.words = "the program could not be linked: " + how_it_ended(linked);
    }
    std::error_code failed;
    fs::remove(object, failed);
    if (built.error || !built.words.empty()) return built;
    remove_all_that_begin_with(exercise.name + "-", shop.folder);
    fs::rename(made, program, failed);
    check(failed, program);
    return built;
}

/// Returns the flags for what the renderer is compiled for.
std::vector<std::string> rules_of(const Exercise& exercise, const Options& options) {
    std::vector<std::string> flags_for{fmt::format("-DGLASSBOX_SPHERE_RULE={}", struct_of(options.sphere_rule)),
                                       fmt::format("-DGLASSBOX_TRIANGLE_RULE={}", struct_of(options.triangle_rule))};
    if (exercise.own_picture == OwnPicture::by_bounds) flags_for.push_back("-DGLASSBOX_BOUNDED");
    return flags_for;
}

/// Suggests another rule, if the words say that a rule is not written yet.
std::string hint(std::string_view words) {
    for (const char* rule : {"Stable", "Textbook", "Pluecker", "Tolerance", "MoellerTrumbore"})
        if (words.starts_with(fmt::format("`{}`", rule)))
            return "; until it is, another rule can be chosen in the controls";
    return "";
}

std::string count(std::int64_t pixels) { return pixels == 1 ? "1 pixel is" : fmt::format("{} pixels are", pixels); }

/// Describes pixels that are drawn, but not as they should be.
std::string about_pixels(const Drawing& drawing) {
    if (drawing.undecided > 0 && drawing.not_numbers == 0)
        return fmt::format("{} undecided: the bounds leave open what is seen there; the first is ({}, {})",
                           count(drawing.undecided), drawing.first_undecided->x, drawing.first_undecided->y);
    if (drawing.not_numbers == 0) return "";
    return fmt::format("{} made of something that is not a number (NaN), the first at ({}, {})",
                       count(drawing.not_numbers), drawing.first_not_a_number->x, drawing.first_not_a_number->y);
}

PictureUpdate update_of(const Drawn& drawn) {
    PictureUpdate update;
    update.drawing = drawn.drawing;
    update.said = drawn.outcome.output + drawn.outcome.errors;
    update.draw_seconds = drawn.outcome.took.count();
    update.words = what_became_of(drawn);
    if (drawn.not_written) {
        update.stand = Stand::not_written;
        update.words += hint(update.words);
        return update;
    }
    update.stand = update.words.empty() ? Stand::drawn : Stand::failed;
    update.spot = drawn.spot;
    const std::string more = about_pixels(*drawn.drawing);
    if (more.empty()) return update;
    const Drawing& drawing = *drawn.drawing;
    if (update.stand == Stand::drawn)
        update.spot = drawing.not_numbers > 0 ? drawing.first_not_a_number : drawing.first_undecided;
    update.words += (update.words.empty() ? "" : "; ") + more;
    return update;
}

}  // namespace

void Maker::make(const Workspace& workspace, const Exercise& exercise, const Scene& scene, const Options& options,
                 const std::function<void(PictureUpdate)>& tell, const std::stop_token& stop) {
    std::error_code none;
    std::vector<std::string> parts;
    try {
        if (exercise.own_picture == OwnPicture::none)
            throw Error(
                fmt::format("the picture beside ours is not made by what {} teaches; '{} learn picture {}' "
                            "draws one that is",
                            exercise.name, workspace.program, exercise.number));
        if (!fs::is_directory(workspace.headers_of(exercise), none))
            throw Error(fmt::format("{} is not begun: '{} learn test {}' makes the files that you write",
                                    shown(workspace.headers_of(exercise)), workspace.program, exercise.number));
        // A missing header must not be replaced by ours silently.
        for (const std::string& header : exercise.headers) parts.push_back(read_header(workspace, exercise, header));
    } catch (const Error& error) {
        PictureUpdate update;
        update.stand = Stand::not_there;
        update.words = error.what();
        return tell(std::move(update));
    }
    if (!compiler_) compiler_ = find_compiler();
    parts.push_back(state_of_ours(workspace.root));
    const std::vector<std::string> rules = rules_of(exercise, options);
    parts.insert(parts.end(), rules.begin(), rules.end());

    const auto start = Clock::now();
    fs::path program;
    double compile_seconds = 0;
    {
        PictureUpdate update;
        update.words = "compiling " + shown(workspace.headers_of(exercise));
        const Workshop shop = workshop(workspace, *compiler_, stop);
        program = shop.folder / (exercise.name + "-" + fingerprint(parts));
        if (!fs::is_regular_file(program, none)) {
            tell(update);
            const Built built = build(workspace, exercise, *compiler_, shop, rules, program, stop);
            compile_seconds = seconds_since(start);
            if (built.error || !built.words.empty()) {
                update.stand = Stand::does_not_compile;
                update.error = built.error;
                update.words = built.words;
                update.compile_seconds = compile_seconds;
                if (built.error) {
                    Place place = built.error->place;
                    place.file = shown(place.file);
                    update.words =
                        error_at(place, built.error->message.empty() ? built.error->plain : built.error->message)
                            .what();
                }
                return tell(std::move(update));
            }
        }
    }
    const auto show = [&](std::shared_ptr<const Drawing> drawing) {
        PictureUpdate update;
        update.stand = Stand::drawing;
        const double all = 1.0 * scene.width * scene.height;
        update.words = fmt::format("drawing: {:.0f} %", 100 * static_cast<double>(drawing->drawn) / all);
        update.drawing = std::move(drawing);
        update.compile_seconds = compile_seconds;
        tell(std::move(update));
    };
    const Drawn drawn = draw(program, scene, options, show, stop);
    if (stop.stop_requested()) throw Cancelled{};
    PictureUpdate update = update_of(drawn);
    update.compile_seconds = compile_seconds;
    tell(std::move(update));
}

}  // namespace glassbox::learn::mine
