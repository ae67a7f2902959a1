#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <iostream>
#include <memory>
#include <span>

#include "cli/commands.hpp"
#include "cli/tell.hpp"
#include "learn/check/detective.hpp"
#include "learn/learner.hpp"
#include "learn/picture/learners_picture.hpp"
#include "learn/report/grade.hpp"
#include "learn/report/page.hpp"
#include "learn/telling.hpp"
#include "learn/watch.hpp"
#include "output/output_file.hpp"
#include "output/whole_file.hpp"
#include "render/job.hpp"
#include "scene/error.hpp"
#include "scene/shell_word.hpp"
#include "scene/suggestion.hpp"
#include "scene/text_file.hpp"

namespace glassbox {

namespace {

using namespace learn;
namespace fs = std::filesystem;

struct LearnRequest {
    std::string lesson, mistake, folder, picture, report = "report.html";
    std::vector<std::string> learners;
    bool record = false, solution = false, isolated = false;
};

/// A stranger's folder may contain programs that look like ours: isolated, ours are built elsewhere.
Workspace workspace_for(const LearnRequest& request) {
    Workspace workspace = open_workspace(fs::current_path(), request.folder);
    if (request.isolated) workspace.hidden_elsewhere = workspace.usual_folder / ".glassbox" / "isolated";
    return workspace;
}

/// A running subcommand of `learn`.
struct LearnRun {
    const LearnRequest& request;
    std::stop_token stop;
    Learner learner;
    Paint paint;

    LearnRun(const LearnRequest& asked, std::stop_token token)
        : request(asked),
          stop(std::move(token)),
          learner(
              workspace_for(asked), [](const std::string& text) { tell("glassbox learn: " + text); }, asked.isolated),
          paint{is_terminal() && !no_color(), width()} {}

    const Exercise& exercise() { return learner.lesson(request.lesson); }

    static bool is_terminal() { return ::isatty(STDOUT_FILENO) == 1; }
    /// How many characters a line may have: as many as the terminal shows, but not more than are easy to read.
    static std::size_t width() {
        constexpr std::size_t least = 40, most = 100;
        winsize size{};
        const bool is_known = ::ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0;
        return is_known ? std::clamp(std::size_t{size.ws_col}, least, most) : most;
    }
    static bool no_color() {
        const char* wish = std::getenv("NO_COLOR");
        return wish && *wish;
    }
};

void print(const std::string& text) {
    fmt::print("{}", text);
    std::fflush(stdout);
}

[[noreturn]] void end_with(int status) { throw CLI::RuntimeError(status); }

/// Tests a lesson and prints the result. Returns whether it passed.
bool test(LearnRun& lesson, const Exercise& exercise) {
    const bool begins = make_starters(lesson.learner.workspace(), exercise);
    if (begins)
        print(fmt::format("Your headers of lesson {} are now in {}: the starters, to be completed.\n\n",
                          exercise.number, shown(lesson.learner.workspace().headers_of(exercise))));
    if (LearnRun::is_terminal()) print(lesson.paint.faint(fmt::format("Testing lesson {} …\n", exercise.number)));
    const TestedLesson tested = lesson.learner.test(
        exercise, lesson.stop, [&](const TestRun& so_far) { print(so_far_text(exercise, so_far, lesson.paint)); });
    if (tested.run.stopped) throw Cancelled{};
    print(tested_text(lesson.learner, exercise, tested, lesson.paint));
    return tested.run.passed();
}

/// Tests the lesson after each change, until it is interrupted.
void watch(LearnRun& lesson) {
    const std::string asked = lesson.request.lesson;
    while (!lesson.stop.stop_requested()) {
        const Exercise& exercise = lesson.learner.lesson(asked);
        Watch headers(lesson.learner.workspace().headers_of(exercise));  // before the test, so that no change is missed
        try {
            if (make_starters(lesson.learner.workspace(), exercise)) continue;
            test(lesson, exercise);
        } catch (const Cancelled&) {
            break;
        } catch (const Error& error) {  // a header is missing for now, or the disk is full: that may change
            tell(error.what());
        }
        const Exercise& next = lesson.learner.lesson(asked);
        if (&next != &exercise) continue;
        print(lesson.paint.faint(fmt::format("\nWatching {}; save a file to test again, Ctrl-C to end.\n",
                                             shown(lesson.learner.workspace().headers_of(exercise)))));
        if (!headers.wait(lesson.stop)) break;
        print(LearnRun::is_terminal() ? "\x1b[H\x1b[2J" : "\n");  // keeps the scrollback
    }
}

void status(LearnRun& lesson) {
    make_starters(lesson.learner.workspace(), lesson.exercise());  // so that there is something to open
    print(status_text(lesson.learner, lesson.paint));
}

void hint(LearnRun& lesson) {
    const Exercise& exercise = lesson.exercise();
    make_starters(lesson.learner.workspace(), exercise);
    const Function* function = lesson.learner.next_function(exercise, lesson.stop);
    if (!function) return print(fmt::format("All of lesson {} is written: no hint is left.\n", exercise.number));
    const int tier = lesson.learner.next_hint(exercise, *function);
    print(hint_text(lesson.learner.workspace(), exercise, *function, tier, lesson.paint));
}

/// Restores the starters of one lesson, which must be named; sets aside what is written there.
void begin_anew(LearnRun& lesson) {
    const Exercise& exercise = lesson.exercise();
    const Workspace& workspace = lesson.learner.workspace();
    lesson.learner.forget(exercise);
    if (make_starters(workspace, exercise))
        return print(fmt::format("The starters of lesson {} are in {}.\n", exercise.number,
                                 shown(workspace.headers_of(exercise))));
    for (const fs::path& kept : reset(workspace, exercise)) print(fmt::format("Kept: {}\n", shown(kept)));
    print(fmt::format("Lesson {} begins anew, in {}.\n", exercise.number, shown(workspace.headers_of(exercise))));
}

bool agrees(const std::string& question) {
    if (::isatty(STDIN_FILENO) != 1 || ::isatty(STDERR_FILENO) != 1) return true;
    fmt::print(stderr, "{} [y/N] ", question);
    std::string answer;
    std::getline(std::cin, answer);
    return answer == "y" || answer == "Y" || answer == "yes";
}

void solution(LearnRun& lesson) {
    const Exercise& exercise = lesson.exercise();
    if (!lesson.learner.progress(exercise).passed) {
        if (!agrees(fmt::format("Lesson {} has not passed yet. Give up, and see the solution?", exercise.number))) {
            tell(fmt::format("glassbox learn: not shown; for a hint: {}",
                             command_line(lesson.learner.workspace(), fmt::format("hint {}", exercise.number))));
            end_with(1);
        }
        lesson.learner.remember_giving_up(exercise);
    }
    for (const std::string& header : exercise.headers) {
        const fs::path path = lesson.learner.workspace().solution(exercise, header);
        tell(fmt::format("glassbox learn: {}:", shown(path)));
        print(read_text(path));
    }
}

const Mistake& mistake_called(const std::vector<Mistake>& mistakes, const std::string& name, const Exercise& exercise) {
    std::vector<std::string_view> names;
    for (const Mistake& mistake : mistakes) {
        if (mistake.name == name) return mistake;
        names.push_back(mistake.name);
    }
    throw Error(fmt::format("glassbox learn: error: lesson {} knows no mistake {}; {}", exercise.number,
                            in_quotes(name), suggestion(name, names)));
}

/// The folder with a lesson's headers for a picture: the learner's, the solution, or those with a mistake.
fs::path headers_for_picture(LearnRun& lesson, const Exercise& exercise) {
    const Workspace& workspace = lesson.learner.workspace();
    if (lesson.request.solution) return workspace.solutions_of(exercise);
    if (lesson.request.mistake.empty()) {
        make_starters(workspace, exercise);
        for (const std::string& header : exercise.headers) read_header(workspace, exercise, header);
        return workspace.headers_of(exercise);
    }
    const std::vector<Mistake> mistakes = read_mistakes(exercise);
    const Mistake& mistake = mistake_called(mistakes, lesson.request.mistake, exercise);
    const fs::path folder = workspace.hidden() / "mistakes" / exercise.name / mistake.name / "headers";
    make_mistaken_headers(workspace, exercise, mistake, folder);
    return folder;
}

std::string whose_headers(const LearnRequest& request) {
    if (request.solution) return "by our headers";
    return request.mistake.empty() ? "by your headers" : fmt::format("with the mistake {}", request.mistake);
}

/// The command line that draws it again: none for the learner's own headers, which will change.
Origin origin_of_picture(const LearnRequest& request, const Exercise& exercise) {
    if (!request.solution && request.mistake.empty()) return {};
    const std::string whose = request.solution ? "--solution" : "--mistake " + shell_word(request.mistake);
    return {fmt::format("glassbox learn picture {} {} -o lesson{}{}", exercise.number, whose, exercise.number,
                        picture_extension(request.picture))};
}

void picture(LearnRun& lesson) {
    const Exercise& exercise = lesson.exercise();
    check_picture_file(lesson.request.picture);
    const fs::path headers = headers_for_picture(lesson, exercise);
    const fs::path folder = make_folder(lesson.learner.workspace().hidden() / exercise.name);
    lesson.learner.tools();
    tell(fmt::format("glassbox learn: compiling and drawing lesson {}'s picture, some seconds", exercise.number));
    const LessonPicture made =
        lesson_picture(lesson.learner.workspace(), exercise, lesson.learner.tools(), headers, folder, lesson.stop);
    if (lesson.stop.stop_requested()) throw Cancelled{};
    if (made.error) {
        print(error_text(*made.error, lesson.paint));
        end_with(1);
    }
    if (!made.image)
        throw Error(fmt::format("{}: error: there is no picture: {}; see {}", shown(exercise.lesson / "main.cpp"),
                                made.died,
                                command_line(lesson.learner.workspace(), fmt::format("test {}", exercise.number))));
    write_picture(lesson.request.picture, *made.image, origin_of_picture(lesson.request, exercise), lesson.stop);
    print(fmt::format("{} is written: {}x{} pixels, the picture of lesson {} {}.\n", lesson.request.picture,
                      made.image->width, made.image->height, exercise.number, whose_headers(lesson.request)));
    for (const std::string& line : made.said) tell(line);
}

/// Records the symptoms of each mistake of a lesson, for lesson authors.
void record(LearnRun& lesson, const Exercise& exercise) {
    tell(fmt::format("glassbox learn: compiling and running each mistake of lesson {}: some seconds each",
                     exercise.number));
    int unnoticed = 0;
    const auto done = [&](const Mistake& mistake, const TestRun& run) {
        const std::size_t traces = traces_of(mistake.name, run).size();
        if (run.error) tell(fmt::format("{}: does not compile: {}", mistake.name, run.error->message));
        else if (traces == 0) tell(fmt::format("{}: no test fails", mistake.name));
        if (run.error || traces == 0) ++unnoticed;
    };
    const fs::path file = exercise.lesson / "mistakes.json";
    const std::vector<Trace> traces =
        traces_of_all(lesson.learner.workspace(), exercise, lesson.learner.tools(), done, lesson.stop);
    if (lesson.stop.stop_requested()) throw Cancelled{};
    const std::string text = written(traces);
    write_whole(file, std::as_bytes(std::span(text)));
    print(fmt::format("{}: {} traces\n", shown(file), traces.size()));
    if (unnoticed > 0) end_with(1);
}

void mistake(LearnRun& lesson) {
    const Exercise& exercise = lesson.exercise();
    const Workspace& workspace = lesson.learner.workspace();
    if (lesson.request.record) return record(lesson, exercise);
    const std::vector<Mistake> mistakes = read_mistakes(exercise);
    if (lesson.request.mistake.empty()) {
        for (const Mistake& one : mistakes) {  // a line each, for what reads them from a pipe
            const std::string words =
                LearnRun::is_terminal() ? wrapped(one.looks_like, 29, lesson.paint.width) : one.looks_like;
            print(fmt::format("{:<28} {}\n", one.name, words));
        }
        return;
    }
    const Mistake& chosen = mistake_called(mistakes, lesson.request.mistake, exercise);
    make_starters(workspace, exercise);
    for (const std::string& header : exercise.headers) {
        std::string text = read_text(workspace.solution(exercise, header));
        if (header == chosen.header) text = with_mistake(text, chosen);
        if (const fs::path kept = replace_header(workspace, exercise, header, text); !kept.empty())
            print(fmt::format("Kept: {}\n", shown(kept)));
    }
    print(fmt::format("{} is now the solution with the mistake {}.\n", shown(workspace.headers_of(exercise)),
                      chosen.name));
}

/// Tests all lessons in the learners' folders, writes a page, and prints the table. Reports every error that can be
/// known in advance before the long work; a learner who cannot be graded does not keep others from being graded.
void report(const LearnRequest& request, const std::stop_token& stop) {
    const bool as_csv = request.report.ends_with(".csv");
    check_writable(request.report);
    const Workspace teacher = open_workspace(fs::current_path(), request.folder);
    std::vector<fs::path> paths(request.learners.begin(), request.learners.end());
    if (paths.empty()) paths = {teacher.folder};
    const auto say = [](const std::string& text) { tell("glassbox learn: " + text); };
    const std::vector<HandedIn> all = all_handed_in(teacher, paths, [](const std::string& text) { tell(text); });
    Grader grader(teacher, request.isolated ? Isolating::always : Isolating::where_possible, say);
    const std::string& why_not = grader.why_not_isolated();
    if (!why_not.empty()) say("note: learners' code runs as you do, with your rights: " + why_not);
    std::vector<LearnerStanding> learners;
    if (!all.empty()) say(fmt::format("testing {}: some seconds a lesson", counted(all.size(), "folder")));
    for (const HandedIn& one : all) try {
            learners.push_back(grader.grade(one, stop));
        } catch (const Error& error) {
            tell(error.what());
            say(fmt::format("{} is left out", one.learner));
        }
    if (learners.empty()) end_with(1);
    const std::string how =
        why_not.empty() ? "Learners’ code ran isolated: without network, without your files and your other programs."
                        : "Learners’ code ran as you do, with your rights: " + why_not + ".";
    const std::string text = as_csv ? to_csv(learners) : to_html(learners, how);
    write_whole(request.report, std::as_bytes(std::span(text)), stop);
    print(to_table(learners));
    if (learners.size() < all.size()) end_with(1);
}

using Run = std::function<void(LearnRun&)>;

/// Adds a subcommand to `learn`.
CLI::App* add(CLI::App& learn, Session& session, const std::shared_ptr<LearnRequest>& request, const char* name,
              const char* help, Run run) {
    CLI::App* command = learn.add_subcommand(name, help);
    command->callback([request, &session, run = std::move(run)] {
        LearnRun lesson(*request, session.interrupt.token());
        run(lesson);
    });
    return command;
}

CLI::Option* add_lesson(CLI::App* command, const std::shared_ptr<LearnRequest>& request) {
    return command->add_option("N", request->lesson, "the lesson, its number or name (default: the first that is open)")
        ->type_name(" ");
}

void add_isolated(CLI::App* command, const std::shared_ptr<LearnRequest>& request, const char* help) {
    command->add_flag("--isolated", request->isolated, help);
}

}  // namespace

void add_learn(CLI::App& program, Session& session) {
    const auto request = std::make_shared<LearnRequest>();
    CLI::App* learn = program.add_subcommand("learn", "Follow the lessons: write the functions, test them, see them");
    learn->require_subcommand(0, 1);

    add(*learn, session, request, "status", "Show the lessons, how far you are, and what to do next", status);
    CLI::App* test_command = add(*learn, session, request, "test", "Test what you have written", [](LearnRun& lesson) {
        if (!test(lesson, lesson.exercise())) end_with(1);
    });
    add_lesson(test_command, request);
    add_isolated(test_command, request, "for what others wrote: without network, files and other programs");
    add_lesson(add(*learn, session, request, "watch", "Test after each change, until Ctrl-C", watch), request);
    add_lesson(add(*learn, session, request, "hint", "A hint: a question, then the formula, then the code", hint),
               request);
    CLI::App* picture_command =
        add(*learn, session, request, "picture", "Make the lesson's picture with your functions", picture);
    add_lesson(picture_command, request);
    picture_command->add_option("-o,--out", request->picture, "the picture, .png or .ppm")
        ->type_name("OUT.png")
        ->required();
    picture_command->add_option("--mistake", request->mistake, "with the solution and this mistake, instead of yours")
        ->type_name("NAME");
    picture_command->add_flag("--solution", request->solution, "with the solution, instead of yours")
        ->excludes("--mistake");
    add_isolated(picture_command, request, "for what others wrote: without network, files and other programs");
    add_lesson(
        add(*learn, session, request, "solution", "Show our headers; asks first if yours have not passed", solution),
        request);
    add_lesson(
        add(*learn, session, request, "reset", "Begin a lesson anew; what you have is kept beside it", begin_anew),
        request)
        ->required();
    CLI::App* mistake_command =
        add(*learn, session, request, "mistake",
            "For teachers: list a lesson's classic mistakes, or make one in your folder", mistake);
    add_lesson(mistake_command, request)->required();
    mistake_command->add_option("NAME", request->mistake, "the mistake to make")->type_name(" ");
    mistake_command->add_flag("--record", request->record,
                              "write lessons/N-name/mistakes.json anew: for lessons' authors");

    CLI::App* report_command =
        learn->add_subcommand("report", "For teachers: test the folders of learners, and write a page about them");
    report_command->add_option("FOLDER", request->learners, "learners' folders (default: yours)")->type_name(" ");
    report_command->add_option("-o,--out", request->report, "the page, .html, or its numbers, .csv")
        ->type_name("OUT.html")
        ->capture_default_str();
    add_isolated(report_command, request, "refuse to run what others wrote where that cannot be isolated");
    report_command->callback([request, &session] { report(*request, session.interrupt.token()); });

    for (CLI::App* command : learn->get_subcommands([](const CLI::App*) { return true; }))
        command->add_option("--folder", request->folder, "your folder (default: my/ in the project)")->type_name("DIR");
    learn->add_option("--folder", request->folder, "your folder (default: my/ in the project)")->type_name("DIR");
    learn->footer("Example: glassbox learn test 1. Without a command: status, and on a terminal watch.");
    learn->callback([request, &session, learn] {
        if (!learn->get_subcommands().empty()) return;
        LearnRun lesson(*request, session.interrupt.token());
        status(lesson);
        if (!LearnRun::is_terminal()) return;
        print("\n");
        watch(lesson);
    });
}

}  // namespace glassbox
