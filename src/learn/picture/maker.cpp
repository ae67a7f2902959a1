#include "learn/picture/maker.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <functional>
#include <string_view>
#include <thread>
#include <utility>

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
    for (const char* folder :
         {"src/core", "src/numerics", "src/scene", "src/render", "src/explain", "src/learn/picture"})
        for (const fs::directory_entry& entry : fs::recursive_directory_iterator(root / folder, none))
            if (entry.is_regular_file(none)) states.push_back(state_of(entry.path()));
    std::sort(states.begin(), states.end());
    return fingerprint(states);
}

/// The learner's headers come before ours; those of all other lessons are ours.
std::vector<fs::path> includes(const Workspace& workspace, const Lessons& lessons) {
    std::vector<fs::path> stages;
    std::error_code none;
    for (const fs::directory_entry& entry : fs::directory_iterator(workspace.root / "src/core", none))
        if (entry.is_directory(none)) stages.push_back(entry.path());
    std::sort(stages.begin(), stages.end());
    std::vector<fs::path> all;
    for (const Exercise* const exercise : lessons) all.push_back(workspace.headers_of(*exercise));
    all.push_back(workspace.root / "lessons");
    all.insert(all.end(), stages.begin(), stages.end());
    all.push_back(workspace.root / "src");
    return all;
}

/// A name that no other process or thread uses meanwhile.
std::string unique(std::string_view begin) {
    return fmt::format("{}-{}-{}", begin, ::getpid(), std::hash<std::thread::id>{}(std::this_thread::get_id()));
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
    const fs::path making = workspace.hidden() / unique("new-drawing");
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
    if (failed) fs::remove_all(making, failed);  // another process or thread was faster
    return shop;
}

PictureUpdate update(Stand stand, std::string words) {
    PictureUpdate update;
    update.stand = stand;
    update.words = std::move(words);
    return update;
}

/// "file:line:column: error: message", for a learner's eyes.
std::string in_one_line(const CompileError& error) {
    const Place place{shown(error.place.file), error.place.line, error.place.column};
    return error_at(place, error.message.empty() ? error.plain : error.message).what();
}

/// What is to be said of a compiler's or linker's run that failed; none if it did well. `error` is what was found in
/// its output, `what` what could not be done.
std::optional<PictureUpdate> failure_of(const Outcome& outcome, std::optional<CompileError> error, const char* what) {
    if (!error && outcome.well()) return {};
    PictureUpdate failed = update(Stand::does_not_compile, error ? in_one_line(*error) : what + how_it_ended(outcome));
    failed.error = std::move(error);
    return failed;
}

/// Returns the flags for what the renderer is compiled for.
std::vector<std::string> rules_of(const Lessons& lessons, const Options& options) {
    std::vector<std::string> flags_for{fmt::format("-DGLASSBOX_SPHERE_RULE={}", struct_of(options.sphere_rule)),
                                       fmt::format("-DGLASSBOX_TRIANGLE_RULE={}", struct_of(options.triangle_rule))};
    const auto is_by_bounds = [](const Exercise* exercise) { return exercise->own_picture == OwnPicture::by_bounds; };
    if (std::any_of(lessons.begin(), lessons.end(), is_by_bounds)) flags_for.push_back("-DGLASSBOX_BOUNDED");
    return flags_for;
}

/// The lesson's name, or "all" of several.
std::string name_of(const Lessons& lessons) { return lessons.size() == 1 ? lessons[0]->name : "all"; }

/// The learner's headers of a lesson, by their texts. A missing one must not be replaced by ours silently. Throws Error
/// if one is not there, or if the lesson has no picture.
std::vector<std::string> headers_to_draw_with(const Workspace& workspace, const Exercise& exercise) {
    if (exercise.own_picture == OwnPicture::none)
        throw Error(
            fmt::format("the picture beside ours is not made by what {} teaches; '{} learn picture {}' "
                        "draws one that is",
                        exercise.name, workspace.program, exercise.number));
    check_begun(workspace, exercise);
    std::vector<std::string> texts;
    for (const std::string& header : exercise.headers) texts.push_back(read_header(workspace, exercise, header));
    return texts;
}

/// The same for each of the lessons, after its name.
std::vector<std::string> headers_to_draw_with(const Workspace& workspace, const Lessons& lessons) {
    std::vector<std::string> all;
    for (const Exercise* const exercise : lessons) {
        all.push_back(exercise->name);
        for (std::string& text : headers_to_draw_with(workspace, *exercise)) all.push_back(std::move(text));
    }
    return all;
}

/// "my/1-rays, my/2-spheres"
std::string folders_of(const Workspace& workspace, const Lessons& lessons) {
    std::vector<std::string> folders;
    for (const Exercise* const exercise : lessons) folders.push_back(shown(workspace.headers_of(*exercise)));
    return fmt::format("{}", fmt::join(folders, ", "));
}

OwnHeaders own_headers(const Workspace& workspace, const Lessons& lessons) {
    OwnHeaders all;
    for (const Exercise* const exercise : lessons) {
        const OwnHeaders own = learn::own_headers(*exercise, workspace.headers_of(*exercise));
        all.folders.insert(all.folders.end(), own.folders.begin(), own.folders.end());
        all.included.insert(all.included.end(), own.included.begin(), own.included.end());
    }
    return all;
}

/// A program that is compiled with the learner's headers.
struct Program {
    const char* source;  ///< in src/learn/picture
    const char* prefix;  ///< of its name
};
constexpr Program renderer_program{"renderer.cpp", ""}, stepper_program{"stepper.cpp", "steps-"};
/// The renderer once more, to see whether it compiles: another thread may be making that itself.
constexpr Program trial_program{"renderer.cpp", "trial-"};

/// How the names of all programs begin that were compiled for these lessons.
std::string beginning_of(const Program& program, const Lessons& lessons) {
    return program.prefix + name_of(lessons) + "-";
}

/// Where the program is that was compiled from all of this, if it was.
fs::path compiled_to(const Program& program, const Workshop& shop, const Workspace& workspace, const Lessons& lessons,
                     std::vector<std::string> headers, const std::vector<std::string>& rules) {
    headers.push_back(state_of_ours(workspace.root));
    headers.insert(headers.end(), rules.begin(), rules.end());
    return shop.folder / (beginning_of(program, lessons) + fingerprint(headers));
}

/// Compiles and links a program. Returns why it could not, if it could not.
std::optional<PictureUpdate> build(const Program& which, const fs::path& to, const Workshop& shop,
                                   const Workspace& workspace, const Lessons& lessons, const Compiler& compiler,
                                   std::vector<std::string> rules, const std::stop_token& stop) {
    const auto unless_stopped = [&](Outcome outcome) {
        if (stop.stop_requested()) throw Cancelled{};
        return outcome;
    };
    const fs::path program = shop.folder / unique("new");
    const fs::path object = fs::path(program) += ".o";
    rules.insert(rules.begin(), flags.begin(), flags.end());
    for (const std::string& flag : beginning_with(compiler, shop.folder / shop.precompiled)) rules.push_back(flag);
    const Compilation what{workspace.root / "src/learn/picture" / which.source, object, includes(workspace, lessons),
                           rules, workspace.root};

    const Outcome compiled = unless_stopped(compile(compiler, what, stop));
    const OwnHeaders own = own_headers(workspace, lessons);
    std::optional<PictureUpdate> failure =
        failure_of(compiled, compile_error(compiled, own, workspace.root), "the compiler could not compile it: ");
    if (!failure) {
        const Outcome linked = unless_stopped(link(compiler, {object}, program, "", stop));
        failure = failure_of(linked, link_error(linked), "the program could not be linked: ");
    }
    std::error_code failed;
    fs::remove(object, failed);
    if (failure) return failure;
    remove_all_that_begin_with(beginning_of(which, lessons), shop.folder);
    fs::rename(program, to, failed);
    check(failed, to);
    return {};
}

/// Suggests another rule, if the words say that a function of one rule only is not written yet.
std::string hint(std::string_view words, const Lessons& lessons) {
    const auto is_of_a_rule = [&](const Function& function) {
        return !function.rule.empty() && words.starts_with(fmt::format("`{}`", function.name));
    };
    const bool is_missing = std::any_of(lessons.begin(), lessons.end(), [&](const Exercise* exercise) {
        return std::any_of(exercise->functions.begin(), exercise->functions.end(), is_of_a_rule);
    });
    return is_missing ? "; until it is, another rule can be chosen in the controls" : "";
}

/// Throws Error for a lesson whose functions compute no pixel in plain numbers.
void check_can_be_recorded(const Lessons& lessons) {
    for (const Exercise* const exercise : lessons)
        if (exercise->own_picture == OwnPicture::by_bounds)
            throw Error(
                fmt::format("the steps of {} cannot be recorded: it computes bounds of numbers, and not the "
                            "numbers of a pixel; the lessons before it can be stepped",
                            exercise->name));
}

/// What is said after an error that is none without recording.
constexpr const char* how_to_be_recorded =
    "; it compiles in double, but steps are recorded in numbers of our own: write `Real` (or `auto`) where it says "
    "`double`, and `using std::sqrt;` and then `sqrt(x)` instead of `std::sqrt(x)`";

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

/// Says what is drawn so far.
PictureUpdate update_of(std::shared_ptr<const Drawing> drawing, const Scene& scene) {
    const double all = 1.0 * scene.width * scene.height;
    PictureUpdate so_far =
        update(Stand::drawing, fmt::format("drawing: {:.0f} %", 100 * static_cast<double>(drawing->drawn) / all));
    so_far.drawing = std::move(drawing);
    return so_far;
}

/// Says how the drawing ended.
PictureUpdate update_of(const Drawn& drawn, const Lessons& lessons) {
    PictureUpdate end = update(Stand::drawn, what_became_of(drawn));
    end.drawing = drawn.drawing;
    end.said = drawn.outcome.output + drawn.outcome.errors;
    end.draw_seconds = drawn.outcome.took.count();
    if (drawn.not_written) {
        end.stand = Stand::not_written;
        end.words += hint(end.words, lessons);
        return end;
    }
    if (!end.words.empty()) end.stand = Stand::failed;
    end.spot = drawn.spot;
    const Drawing& drawing = *drawn.drawing;
    const std::string more = about_pixels(drawing);
    if (more.empty()) return end;
    if (end.stand == Stand::drawn)
        end.spot = drawing.not_numbers > 0 ? drawing.first_not_a_number : drawing.first_undecided;
    end.words += (end.words.empty() ? "" : "; ") + more;
    return end;
}

}  // namespace

void Maker::make(const Workspace& workspace, const Lessons& lessons, const Scene& scene, const Options& options,
                 const std::function<void(PictureUpdate)>& tell, const std::stop_token& stop) {
    std::vector<std::string> headers;
    try {
        headers = headers_to_draw_with(workspace, lessons);
    } catch (const Error& error) {
        return tell(update(Stand::not_there, error.what()));
    }
    if (!compiler_) compiler_ = find_compiler();

    const auto start = Clock::now();
    double compile_seconds = 0;
    const auto tell_timed = [&](PictureUpdate update) {
        update.compile_seconds = compile_seconds;
        tell(std::move(update));
    };
    const std::vector<std::string> rules = rules_of(lessons, options);
    const Workshop shop = workshop(workspace, *compiler_, stop);
    const fs::path renderer = compiled_to(renderer_program, shop, workspace, lessons, std::move(headers), rules);
    std::error_code none;
    if (!fs::is_regular_file(renderer, none)) {
        tell(update(Stand::compiling, "compiling " + folders_of(workspace, lessons)));
        std::optional<PictureUpdate> failure =
            build(renderer_program, renderer, shop, workspace, lessons, *compiler_, rules, stop);
        compile_seconds = seconds_since(start);
        if (failure) return tell_timed(*std::move(failure));
    }

    const auto show = [&](std::shared_ptr<const Drawing> drawing) { tell_timed(update_of(std::move(drawing), scene)); };
    const Drawn drawn = draw(renderer, scene, options, show, stop);
    if (stop.stop_requested()) throw Cancelled{};
    tell_timed(update_of(drawn, lessons));
}

void Maker::record(const Workspace& workspace, const Lessons& lessons, const ToRecord& what,
                   const std::function<void(RecordingUpdate)>& tell, const std::stop_token& stop) {
    const auto tell_words = [&](Stand stand, std::string words) {
        RecordingUpdate update;
        update.stand = stand;
        update.words = std::move(words);
        tell(std::move(update));
    };
    std::vector<std::string> texts;
    std::vector<OwnHeader> headers;
    try {
        check_can_be_recorded(lessons);
        texts = headers_to_draw_with(workspace, lessons);
        for (const Exercise* const exercise : lessons)
            for (const std::string& header : exercise->headers)
                headers.push_back({workspace.header(*exercise, header), read_header(workspace, *exercise, header)});
    } catch (const Error& error) {
        return tell_words(Stand::not_there, error.what());
    }
    if (!compiler_) compiler_ = find_compiler();

    const auto start = Clock::now();
    double compile_seconds = 0;
    const std::vector<std::string> rules = rules_of(lessons, what.options);
    const Workshop shop = workshop(workspace, *compiler_, stop);
    const fs::path stepper = compiled_to(stepper_program, shop, workspace, lessons, texts, rules);
    std::error_code none;
    if (!fs::is_regular_file(stepper, none)) {
        tell_words(Stand::compiling, "compiling " + folders_of(workspace, lessons) + ", to record its steps");
        const std::optional<PictureUpdate> failure =
            build(stepper_program, stepper, shop, workspace, lessons, *compiler_, rules, stop);
        if (failure) {
            RecordingUpdate update;
            update.stand = failure->stand;
            update.words = failure->words;
            update.error = failure->error;
            const fs::path renderer = compiled_to(renderer_program, shop, workspace, lessons, texts, rules);
            const fs::path tried = compiled_to(trial_program, shop, workspace, lessons, texts, rules);
            if (fs::is_regular_file(renderer, none) || fs::is_regular_file(tried, none) ||
                !build(trial_program, tried, shop, workspace, lessons, *compiler_, rules, stop))
                update.words += how_to_be_recorded;
            return tell(std::move(update));
        }
        compile_seconds = seconds_since(start);
    }
    RecordingUpdate update = mine::record(stepper, what, workspace.root, headers, stop);
    if (stop.stop_requested()) throw Cancelled{};
    if (update.stand == Stand::not_written) update.words += hint(update.words, lessons);
    update.compile_seconds = compile_seconds;
    tell(std::move(update));
}

void Maker::record_with_all(const Workspace& workspace, const ToRecord& what,
                            const std::function<void(RecordingUpdate)>& tell, const std::stop_token& stop) {
    const Written written = written_in(workspace);
    if (!written.finished.empty()) return record(workspace, written.finished, what, tell, stop);
    RecordingUpdate update;
    update.stand = Stand::not_there;
    update.words = in_words(written, workspace);
    tell(std::move(update));
}

void Maker::make_with_all(const Workspace& workspace, const Scene& scene, const Options& options,
                          const std::function<void(PictureUpdate)>& tell, const std::stop_token& stop) {
    const Written written = written_in(workspace);
    const std::string words = in_words(written, workspace);
    if (written.finished.empty()) return tell(update(Stand::not_there, words));
    const auto tell_by_whom = [&](PictureUpdate update) {
        update.by_whom = words;
        tell(std::move(update));
    };
    make(workspace, written.finished, scene, options, tell_by_whom, stop);
}

}  // namespace glassbox::learn::mine
