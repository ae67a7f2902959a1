#include "learn/report/grade.hpp"

#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>

#include "learn/build/headers.hpp"
#include "learn/learner.hpp"
#include "learn/picture/learners_picture.hpp"
#include "learn/telling.hpp"
#include "render/job.hpp"

namespace glassbox::learn {

namespace {

namespace fs = std::filesystem;

/// Whether any header of the lesson differs from its starter.
bool is_begun(const Workspace& workspace, const Exercise& exercise) {
    return std::ranges::any_of(exercise.headers, [&](const std::string& header) {
        const std::string written = content_of(workspace.header(exercise, header));
        return !written.empty() && written != workspace.starter(exercise, header);
    });
}

/// Whether a path, with all links resolved, is in that folder.
bool is_really_in(const fs::path& folder, const fs::path& path) {
    std::error_code none;
    const fs::path near = fs::relative(path, folder, none);  // both without links
    return !none && !near.empty() && *near.begin() != "..";
}

/// Returns what is wrong with a header that is missing, is no text file, or is a link to somebody else's file; "" if
/// all can be used. Ours must not take its place.
std::string why_unusable(const Workspace& workspace, const Exercise& exercise) {
    try {
        for (const std::string& header : exercise.headers) {
            const fs::path path = workspace.header(exercise, header);
            std::error_code none;
            if (fs::exists(path, none) && !is_really_in(workspace.folder, path))
                throw error_at({shown(path)}, "this is a link to a file elsewhere; hand in the file itself");
            read_header(workspace, exercise, header);
        }
    } catch (const Error& error) {
        return error.what();
    }
    return "";
}

/// Throws Error if a learner's headers can only be read by root: an isolated compiler does not have root's powers,
/// would report them as unreadable, and that would look like the learner's fault.
void check_readable(const Workspace& workspace, const Exercise& exercise) {
    const auto is_open = [](const fs::path& path, mode_t bits) {
        struct stat found {};
        return ::stat(path.c_str(), &found) != 0 || found.st_uid == 0 || (found.st_mode & bits) == bits;
    };
    if (::geteuid() != 0) return;
    for (const std::string& header : exercise.headers) {
        const fs::path path = workspace.header(exercise, header);
        if (!is_open(path, S_IROTH) || !is_open(path.parent_path(), S_IXOTH))
            throw error_at({shown(path)}, fmt::format("only its owner may read this; let others read it, too: chmod -R "
                                                      "a+rX {}",
                                                      shown(workspace.folder)));
    }
}

/// Returns the progress in the learner's folder, read from a copy, because reading renames an unreadable file.
Progress remembered(const Workspace& learner, const fs::path& scratch, std::string& complaint) {
    const fs::path copy = make_folder(scratch) / "progress.json";
    std::error_code none;
    fs::remove(copy, none);
    fs::copy_file(learner.hidden() / "progress.json", copy, none);
    return read_progress(copy, complaint);
}

Grade grade_of(const TestRun& run, const Judgement& judgement) {
    if (run.error) return Grade::does_not_compile;
    if (run.passed()) return Grade::passed;
    const bool unfinished = run.disturbed.empty() && judgement.failed == 0 && judgement.waiting > 0;
    return unfinished ? Grade::unfinished : Grade::failing;
}

}  // namespace

Grader::Grader(Workspace teacher, Isolating isolating, std::function<void(const std::string&)> say)
    : teacher_(std::move(teacher)),
      say_(std::move(say)),
      tools_(toolchain(teacher_, say_)),
      scratch_(make_folder(teacher_.hidden() / "grading")) {
    try {
        tools_ = isolated(tools_, teacher_);
    } catch (const Error& error) {
        if (isolating == Isolating::always) throw;
        const std::string_view words = error.what();
        why_not_isolated_ = words.substr(words.find(": error: ") + 9);
    }
}

const std::optional<Image>& Grader::ours(const Exercise& exercise, const std::stop_token& stop) {
    const auto [place, is_new] = ours_.try_emplace(exercise.number);
    if (is_new) {
        const fs::path folder = make_folder(scratch_ / "ours" / exercise.name);
        place->second = lesson_picture(teacher_, exercise, tools_, teacher_.solutions_of(exercise), folder, stop).image;
    }
    return place->second;
}

LessonStanding Grader::grade(const Workspace& learner, const Exercise& exercise, const std::stop_token& stop) {
    LessonStanding lesson{.number = exercise.number, .title = exercise.title};
    const fs::path folder = make_folder(scratch_ / exercise.name);
    for (const Function& function : exercise.functions) lesson.functions.push_back({function.name, function.header});
    if (!is_begun(learner, exercise)) return lesson;
    lesson.wrong = why_unusable(learner, exercise);
    if (!lesson.wrong.empty()) {
        lesson.grade = Grade::does_not_compile;
        lesson.no_picture = "a header cannot be used";
        return lesson;
    }

    if (tools_.compiler.isolation) check_readable(learner, exercise);
    const TestRun run = run_tests(learner, exercise, tools_, {learner.headers_of(exercise), folder}, stop);
    const Judgement judgement = judged(exercise, run);
    for (std::size_t k = 0; k < lesson.functions.size(); ++k) {
        lesson.functions[k].state = judgement.functions[k].state;
        lesson.functions[k].waits_for = judgement.functions[k].waits_for;
    }
    lesson.grade = grade_of(run, judgement);
    lesson.cases = static_cast<int>(run.cases.size());
    lesson.cases_waiting = judgement.waiting;
    lesson.cases_passed = lesson.cases - judgement.failed - judgement.waiting;
    if (!run.passed()) {
        lesson.wrong = first_wrong_text(learner, exercise, run, judgement, {});
        const Recognised said = recognised(exercise, run, judgement);
        lesson.mistake = said.looks_like;
        lesson.description = said.description;
    }
    const LessonPicture picture = lesson_picture(learner, exercise, tools_, learner.headers_of(exercise), folder, stop);
    lesson.mine = picture.image;
    lesson.no_picture = picture.error ? "the lesson’s program does not compile with these headers" : picture.died;
    lesson.ours = ours(exercise, stop);
    if (stop.stop_requested()) throw Cancelled{};
    return lesson;
}

LearnerStanding Grader::grade(const HandedIn& handed_in, const std::stop_token& stop) {
    const Workspace& learner = handed_in.workspace;
    std::string complaint;
    Progress progress = remembered(learner, scratch_, complaint);
    if (!complaint.empty()) say_(complaint);

    LearnerStanding standing{handed_in.learner, {}, handed_in.notes};
    for (const Exercise& exercise : learner.exercises) {
        say_(fmt::format("{}: lesson {}, {}", standing.learner, exercise.number, exercise.title));
        LessonStanding lesson = grade(learner, exercise, stop);
        const LessonProgress& past = progress.lessons[exercise.name];
        lesson.runs = past.runs;
        lesson.gave_up = past.gave_up;
        for (FunctionStanding& function : lesson.functions) {
            const auto hints = past.hints.find(function.name);
            function.hints = hints == past.hints.end() ? 0 : hints->second;
        }
        standing.lessons.push_back(std::move(lesson));
    }
    return standing;
}

}  // namespace glassbox::learn
