#include "learn/telling.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <set>

#include "learn/build/function_line.hpp"
#include "learn/build/headers.hpp"
#include "numerics/printed_bound.hpp"
#include "render/option_names.hpp"
#include "scene/printable.hpp"
#include "scene/shell_word.hpp"
#include "scene/suggestion.hpp"
#include "scene/text_file.hpp"
#include "scene/utf8.hpp"

namespace glassbox::learn {
namespace {

namespace fs = std::filesystem;

std::string mark(State state, const Paint& paint) {
    switch (state) {
        case State::passed:
            return paint.good("✓");
        case State::failing:
            return paint.bad("✗");
        case State::waiting:
            return paint.faint("…");
        default:
            return paint.faint("·");
    }
}

/// "✓ nearest  · Textbook  … intersect, Stable wait for `Textbook`", in lines that begin with so many spaces.
std::string functions_line(const Exercise& exercise, const std::vector<FunctionJudgement>& functions,
                           std::size_t indent, const Paint& paint) {
    std::string lines;
    std::size_t column = indent;
    for (std::size_t i = 0; i < functions.size(); ++i) {
        const auto& [state, waits_for] = functions[i];
        std::string names = exercise.functions[i].name, waiting;
        if (!waits_for.empty()) {
            const std::size_t first = i;
            for (; i + 1 < functions.size() && functions[i + 1].waits_for == waits_for; ++i)
                names += ", " + exercise.functions[i + 1].name;
            waiting = fmt::format(" {} for `{}`", i == first ? "waits" : "wait", waits_for);
        }
        const std::size_t needs = 4 + names.size() + waiting.size();
        const bool fits = column + needs <= paint.width || lines.empty();
        lines += lines.empty() ? "" : fits ? "  " : '\n' + std::string(indent, ' ');
        column = (fits ? column : indent) + needs;
        lines += fmt::format("{} {}{}", mark(state, paint), names, paint.faint(waiting));
    }
    return lines;
}

std::string indented(std::string_view text, std::string_view by) {
    std::string result;
    for (const std::string_view line : lines_of(text)) result += fmt::format("{}{}\n", by, line);
    return result;
}

/// A row of what a failed case reports, such as "expected   5"; empty if there is nothing to report.
std::string row(std::string_view name, std::string_view value, const Paint& paint) {
    constexpr std::size_t before = 12;
    return value.empty()
               ? ""
               : fmt::format("  {} {}\n", paint.faint(fmt::format("{:<9}", name)), wrapped(value, before, paint.width));
}

/// A paragraph of sentences, after a heading.
std::string paragraph(std::string_view heading, std::string_view text, const Paint& paint) {
    constexpr std::size_t before = 2;
    std::string all = wrapped(fmt::format("{} {}", heading, text), before, paint.width);
    return fmt::format("  {}{}\n", paint.strong(all.substr(0, heading.size())), all.substr(heading.size()));
}

/// A number for a reader: with all its digits if they are few.
std::string readable(double number) {
    const std::string all = fmt::format("{}", number);
    constexpr std::size_t few = 9;
    return all.size() <= few ? all : fmt::format("{:.6g}…", number);
}

std::string readable(const std::vector<double>& numbers) {
    std::vector<std::string> all;
    for (const double number : numbers) all.push_back(readable(number));
    return all.size() == 1 ? all[0] : fmt::format("({})", fmt::join(all, ", "));
}

std::vector<double> three_of(const std::vector<double>& numbers, std::size_t at) {
    return {numbers.begin() + static_cast<std::ptrdiff_t>(at), numbers.begin() + static_cast<std::ptrdiff_t>(at) + 3};
}

/// The ray that was traced and its surface: "P = (0, 0, 8), D = (0, 0, -1)".
std::vector<ToldRow> ray_rows(const Failure& failure) {
    const std::vector<double>& surface = failure.surface;
    if (failure.ray.size() != 6) return {};
    const auto vector = [](const char* name, const std::vector<double>& from, std::size_t at) {
        return fmt::format("{} = {}", name, readable(three_of(from, at)));
    };
    std::vector<ToldRow> rows{{"ray", fmt::format("{}, {}", vector("P", failure.ray, 0), vector("D", failure.ray, 3))}};
    if (surface.size() == 4)
        rows.push_back({"sphere", fmt::format("{}, r = {}", vector("C", surface, 0), readable(surface[3]))});
    if (surface.size() == 9)
        rows.push_back({"triangle", fmt::format("{}, {}, {}", vector("A", surface, 0), vector("B", surface, 3),
                                                vector("C", surface, 6))});
    return rows;
}

/// What the check was made from, but for what it says itself, and for the ray that has its own row.
std::vector<std::string> inputs_of(const Failure& failure) {
    std::vector<std::string> all = failure.subcases;
    std::set<std::string> told;
    const auto is_traced = [&](const Input& input) {
        if (failure.ray.size() != 6) return false;
        if (input.numbers == three_of(failure.ray, 0) || input.numbers == three_of(failure.ray, 3)) return true;
        for (std::size_t at = 0; at + 3 <= failure.surface.size(); at += 3)
            if (input.numbers == three_of(failure.surface, at)) return true;
        return failure.surface.size() == 4 && input.name.ends_with(".r");
    };
    for (const Input& input : failure.inputs) {
        if (input.name == failure.expression || is_traced(input)) continue;
        all.push_back(fmt::format("{} = {}", input.name, readable(input.numbers)));
        told.insert(input.name);
    }
    for (const std::string& context : failure.contexts)
        if (!told.contains(context.substr(0, context.find(" := ")))) all.push_back(context);
    return all;
}

std::string joined(const std::vector<std::string>& texts) { return fmt::format("{}", fmt::join(texts, ", ")); }

/// "my/1-rays/vec3.hpp:57", the line being where the function begins, as far as it can be found.
std::string place_of(const Workspace& workspace, const Exercise& exercise, const Function& function) {
    const fs::path path = workspace.header(exercise, function.header);
    const std::size_t line =
        line_of_function(content_of(path), workspace.starter(exercise, function.header), function.name);
    return line == 0 ? shown(path) : fmt::format("{}:{}", shown(path), line);
}

/// What was expected, and what came out.
struct Sides {
    std::string expected, got;
};

/// The two as a reader wants them: of a == b, b is what is expected; what may hold nothing, an optional, holds
/// something where it counts as true.
Sides sides_of(const Failure& failure) {
    constexpr std::string_view equal = " == ", unprintable = "{?}";
    if (!failure.expected.empty()) return {failure.expected, failure.got};
    if (failure.got == unprintable)
        return failure.negated ? Sides{"nothing", "something"} : Sides{"something", "nothing"};
    const std::size_t at = failure.got.find(equal);
    const bool compares = at != std::string::npos && at == failure.got.rfind(equal) &&
                          failure.got.find(unprintable) == std::string::npos &&
                          failure.expression.find(equal) != std::string::npos;
    if (!compares || failure.negated) return {"", failure.got};
    return {failure.got.substr(at + equal.size()), failure.got.substr(0, at)};
}

std::string failure_text(const Workspace& workspace, const CaseResult& one, const Paint& paint) {
    std::string text;
    for (const auto& [name, value] : failure_rows(workspace, one)) text += row(name, value, paint);
    return text;
}

/// What is remembered of each function of a lesson.
std::vector<FunctionJudgement> remembered(const Exercise& exercise, const LessonProgress& progress) {
    std::vector<FunctionJudgement> functions;
    for (const Function& function : exercise.functions) functions.push_back({state_of(function, progress), ""});
    return functions;
}

std::string bar(std::size_t done, std::size_t all, const Paint& paint) {
    constexpr std::size_t width = 12;
    const std::size_t full = all == 0 ? 0 : done * width / all;
    std::string filled, empty;
    for (std::size_t i = 0; i < width; ++i) (i < full ? filled : empty) += i < full ? "█" : "░";
    return paint.good(filled) + paint.faint(empty);
}

/// How `glassbox view` is called from here.
std::string view_command(const Workspace& workspace) {
    return fmt::format("{} view", command_line(workspace, "").starts_with("./") ? "./glassbox" : "glassbox");
}

/// The options by which the viewer shows the learner's picture of a lesson beside ours.
std::string mine_options(const Workspace& workspace, const Exercise& exercise) {
    std::string options = fmt::format(" --mine={}", exercise.number);
    if (workspace.folder != workspace.usual_folder) options += " --folder " + shell_word(shown(workspace.folder));
    return options;
}

/// How to open the ray of the failing test in the viewer, beside the learner's own picture where that can be drawn.
std::string ray_to_look_at(Learner& learner, const Exercise& exercise, const TestedLesson& tested) {
    if (!tested.pixel) return "";
    const Workspace& workspace = learner.workspace();
    const auto [option, rule] = rule_to_see(exercise, tested.judgement.shown->name);
    const bool all_written = std::ranges::none_of(
        tested.judgement.functions, [](State state) { return state == State::not_written; }, &FunctionJudgement::state);
    return fmt::format(
        "  Look at this ray:  {} {} --pixel {},{}{}{}\n", view_command(workspace),
        shell_word(shown(learner.failing_scene_file())), tested.pixel->first, tested.pixel->second,
        option.empty() ? "" : fmt::format(" --{} {}", option, rule),
        all_written && exercise.own_picture != OwnPicture::none ? mine_options(workspace, exercise) : "");
}

/// Whether all lessons were passed, and nothing has failed in one since.
bool all_is_passed(Learner& learner) {
    return std::ranges::all_of(learner.workspace().exercises, [&](const Exercise& exercise) {
        const LessonProgress& progress = learner.progress(exercise);
        return progress.passed && std::ranges::all_of(remembered(exercise, progress), [](const auto& function) {
                   return function.state == State::passed || function.state == State::unknown;
               });
    });
}

std::string passed_text(Learner& learner, const Exercise& exercise, const TestedLesson& tested, const Paint& paint) {
    const Workspace& workspace = learner.workspace();
    std::string text = fmt::format("{} {}\n\n", paint.good("✓"), paint.strong(all_pass_text(exercise, tested.run)));
    text += fmt::format("  See your picture:       {}\n",
                        command_line(workspace, fmt::format("picture {} -o picture.png", exercise.number)));
    text += fmt::format("  Compare with ours:      {}\n",
                        command_line(workspace, fmt::format("solution {}", exercise.number)));
    const Exercise& next = learner.lesson();
    if (all_is_passed(learner))
        text += &exercise == &workspace.exercises.back() ? "  That was the last one. You have written a ray tracer.\n"
                                                         : "  All lessons are passed.\n";
    else if (!learner.progress(next).passed)
        text += fmt::format("  Next, lesson {}:         {}, and then {}\n", next.number,
                            shown(next.lesson / "README.md"), command_line(workspace, "test"));
    return text;
}

}  // namespace

std::string Paint::set(std::string_view code, std::string_view text) const {
    return colours && !text.empty() ? fmt::format("\x1b[{}m{}\x1b[0m", code, text) : std::string(text);
}

std::string wrapped(std::string_view text, std::size_t indent, std::size_t width) {
    std::string lines;
    std::size_t column = indent;
    bool begins = true;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find_first_of(" \n"), text.size());
        const std::string_view word = text.substr(0, end);
        const bool ends_line = end < text.size() && text[end] == '\n';
        if (!begins && column + 1 + columns(word) > width) {
            lines += '\n' + std::string(indent, ' ');
            column = indent;
            begins = true;
        }
        if (!begins) lines += ' ', ++column;
        lines += word;
        column += columns(word);
        begins = ends_line;
        if (ends_line) lines += '\n' + std::string(indent, ' '), column = indent;
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    return lines;
}

std::string ulps_text(const Failure& failure) {
    constexpr double most = 1e6;
    double ulps = 0;
    const auto [end, error] = std::from_chars(failure.ulps.data(), failure.ulps.data() + failure.ulps.size(), ulps);
    const bool same_sign = failure.expected.starts_with('-') == failure.got.starts_with('-');
    if (failure.ulps.empty() || error != std::errc{} || !(ulps < most) || !same_sign) return "";
    return fmt::format("{} {} in the last place)", rounded_up(ulps, 3), ulps == 1 ? "ulp (unit" : "ulps (units");
}

std::vector<ToldRow> failure_rows(const Workspace& workspace, const CaseResult& one) {
    const Failure& failure = *one.failure;
    const auto [name, scalar] = name_and_scalar(one.name);
    std::vector<ToldRow> rows;
    const auto add = [&](const char* what, std::string value) {
        if (!value.empty()) rows.push_back({what, std::move(value)});
    };
    add("test", scalar.empty() ? std::string(name) : fmt::format("{}; in {}", name, scalar));
    add("checked", failure.expression);
    const auto [expected, got] = sides_of(failure);
    add("expected", expected);
    if (failure.threw.empty() && failure.died.empty()) add("got", got);
    const bool too_much = failure.threw == "std::bad_alloc" || failure.threw == "std::bad_array_new_length";
    add("threw", failure.threw + (too_much ? ": it asked for more memory than it may have" : ""));
    add("died", failure.died);
    add("off by", ulps_text(failure));
    for (ToldRow& row : ray_rows(failure)) rows.push_back(std::move(row));
    add("with", joined(inputs_of(failure)));
    if (!failure.file.empty())
        add("at", fmt::format("{}:{}", shown((workspace.root / failure.file).lexically_normal()), failure.line));
    return rows;
}

std::pair<std::string_view, std::string_view> rule_to_see(const Exercise& exercise, std::string_view test) {
    const Function* const function = function_tested_by(exercise, test);
    const auto is_meant = [&](std::string_view name, std::string_view called) {
        if (function && !function->rule.empty()) return function->rule == name;
        return (function && function->name == called) || test.starts_with(fmt::format("{}:", called));
    };
    for (const auto& [name, rule, help] : sphere_rules)
        if (is_meant(name, struct_of(rule))) return {"sphere", name};
    for (const auto& [name, rule, help] : triangle_rules)
        if (is_meant(name, struct_of(rule))) return {"triangle", name};
    return {};
}

std::string all_pass_text(const Exercise& exercise, const TestRun& run) {
    return fmt::format("All {} of lesson {} pass. {}", counted(run.cases.size(), "test"), exercise.number,
                       exercise.sentence);
}

ToldRow error_heading(const CompileError& error) {
    std::string where = printable(shown(error.place.file));
    if (error.place.line > 0) where += fmt::format(":{}", error.place.line);
    if (error.place.column > 0) where += fmt::format(":{}", error.place.column);
    if (error.place.file.empty()) return {"", "It does not compile."};
    return {where, error.yours || error.ours ? "this does not compile" : "this does not compile with your headers"};
}

std::string error_text(const CompileError& error, const Paint& paint) {
    const auto [where, what] = error_heading(error);
    std::string text = where.empty() ? fmt::format("{} {}\n", paint.bad("✗"), what)
                                     : fmt::format("{} {}: {}\n", paint.bad("✗"), paint.strong(where), what);
    if (!error.source.empty()) text += '\n' + indented(with_caret(error), "    ");
    text += '\n';
    if (!error.plain.empty()) text += fmt::format("  {}\n", wrapped(printable(error.plain), 2, paint.width));
    text += row("compiler", printable(error.message), paint);
    if (error.others > 0)
        text += fmt::format("  {}\n",
                            paint.faint(fmt::format("and {}, most likely because of this one",
                                                    counted(static_cast<std::size_t>(error.others), "more error"))));
    return text;
}

std::string command_line(const Workspace& workspace, std::string_view words) {
    std::error_code failed;
    const bool at_root = fs::equivalent(fs::current_path(failed), workspace.root, failed);
    std::string line = fmt::format("{} learn {}", at_root ? workspace.program : "glassbox", words);
    if (workspace.folder != workspace.usual_folder) line += " --folder " + shell_word(shown(workspace.folder));
    return line;
}

std::string status_text(Learner& learner, const Paint& paint) {
    const Workspace& workspace = learner.workspace();
    const Exercise& present = learner.lesson();
    std::string text = fmt::format("{}, in {}\n\n", paint.strong("Your lessons"), shown(workspace.folder));
    for (const Exercise& exercise : workspace.exercises) {
        const LessonProgress& progress = learner.progress(exercise);
        const std::vector<FunctionJudgement> functions = remembered(exercise, progress);
        const auto done =
            static_cast<std::size_t>(std::ranges::count(functions, State::passed, &FunctionJudgement::state));
        std::string words =
            progress.passed ? "passed" : fmt::format("{} of {}", done, counted(functions.size(), "function"));
        if (progress.gave_up) words += ", the solution was shown";
        int hints = 0;
        for (const auto& [function, count] : progress.hints) hints += count;
        if (hints > 0) words += ", " + counted(static_cast<std::size_t>(hints), "hint");
        text += fmt::format("  {} {:<10} {}  {}\n", exercise.number, exercise.title,
                            bar(progress.passed ? functions.size() : done, functions.size(), paint), words);
        if (&exercise == &present && !progress.passed)
            text += fmt::format("               {}\n", functions_line(exercise, functions, 15, paint));
    }
    const LessonProgress& progress = learner.progress(present);
    if (workspace.program != "./glassbox")
        text +=
            fmt::format("\n{}\n", wrapped(fmt::format("In the texts `./glassbox` is `{}` here; what they call lessons/ "
                                                      "and scenes/ lies in {}.",
                                                      workspace.program, shown(workspace.root)),
                                          0, paint.width));
    if (progress.passed) {
        const bool beside_ours = present.own_picture != OwnPicture::none;
        return text + fmt::format("\nAll are passed. To see yours{}: {}\n", beside_ours ? " beside ours" : "",
                                  beside_ours ? view_command(workspace) + mine_options(workspace, present)
                                              : command_line(workspace,
                                                             fmt::format("picture {} -o picture.png", present.number)));
    }
    text += fmt::format(
        "\n{}\n",
        wrapped(fmt::format("Lesson {}, {}: {}", present.number, present.title, present.sentence), 0, paint.width));
    text += fmt::format("  read    {}\n", shown(present.lesson / "README.md"));
    if (const Function* next = open_function(present, progress))
        text += fmt::format("  {:<7} {} in {}\n", state_of(*next, progress) == State::failing ? "mend" : "write",
                            next->name, place_of(workspace, present, *next));
    text +=
        fmt::format("  then    {}{}\n", command_line(workspace, fmt::format("test {}", present.number)),
                    progress.runs > 0 && !learner.is_tested(present) ? "   (it has changed since it was tested)" : "");
    return text;
}

std::string first_wrong_text(const Workspace& workspace, const Exercise& exercise, const TestRun& run,
                             const Judgement& judgement, const Paint& paint) {
    if (run.error) return error_text(*run.error, paint);
    std::string text;
    if (!run.disturbed.empty()) text += fmt::format("{} {}\n", paint.bad("✗"), run.disturbed);
    const CaseResult* one = judgement.shown;
    if (!one) return text + (run.disturbed.empty() ? "No test has run: were they all taken away?\n" : "");

    const Function* function = judgement.function;
    if (function && one->failure->not_written() == function->name)
        return text + fmt::format("{} Next to write: {} in {}\n", paint.faint("·"), paint.strong(function->name),
                                  place_of(workspace, exercise, *function));
    text += fmt::format(
        "{} {}\n", paint.bad("✗"),
        function ? fmt::format("{} in {}", paint.strong(function->name), place_of(workspace, exercise, *function))
                 : "this is not as it should be");
    text += failure_text(workspace, *one, paint);
    std::vector<std::string> others;
    std::set<std::string> failed;  // a test that fails in double and float counts once
    for (const CaseResult& other : run.cases)
        if (other.failure && other.failure->not_written().empty()) failed.emplace(name_and_scalar(other.name).first);
    failed.erase(std::string(name_and_scalar(one->name).first));
    if (!failed.empty())
        others.push_back(fmt::format("{} more {}", failed.size(), failed.size() == 1 ? "fails" : "fail"));
    if (judgement.waiting > 0)
        others.push_back(fmt::format("{} {} for a function to be written", judgement.waiting,
                                     judgement.waiting == 1 ? "waits" : "wait"));
    if (!others.empty()) text += fmt::format("  {}\n", paint.faint(joined(others)));
    return text;
}

std::string so_far_words(const Exercise& exercise, const TestRun& run) {
    return fmt::format("In {} all {} of lesson {} pass; long double takes a moment more.",
                       fmt::join(run.scalars, " and "), counted(run.cases.size(), "test"), exercise.number);
}

std::string so_far_text(const Exercise& exercise, const TestRun& run, const Paint& paint) {
    return fmt::format("{} {}\n", paint.good("✓"), so_far_words(exercise, run));
}

std::string tested_text(Learner& learner, const Exercise& exercise, const TestedLesson& tested, const Paint& paint) {
    const Workspace& workspace = learner.workspace();
    const TestRun& run = tested.run;
    std::string text =
        fmt::format("{}  {}\n", paint.strong(fmt::format("Lesson {}, {}", exercise.number, exercise.title)),
                    paint.faint(fmt::format("({:.1f} s)", tested.took.count())));
    if (!run.error) text += "  " + functions_line(exercise, tested.judgement.functions, 2, paint) + '\n';
    text += '\n';
    if (run.passed()) return text + passed_text(learner, exercise, tested, paint);
    text += first_wrong_text(workspace, exercise, run, tested.judgement, paint);
    if (run.error || !tested.judgement.shown) return text;
    text += '\n';
    const Recognised& recognised = tested.recognised;
    if (!recognised.name.empty()) text += paragraph("This looks familiar.", recognised.looks_like, paint);
    if (!recognised.description.empty()) text += paragraph("What the checks show:", recognised.description, paint);
    if (!recognised.also_looks_like.empty()) text += paragraph("Also:", recognised.also_looks_like, paint);
    text += ray_to_look_at(learner, exercise, tested);
    text += fmt::format("  A hint:            {}\n", command_line(workspace, fmt::format("hint {}", exercise.number)));
    return text;
}

std::string hint_text(const Workspace& workspace, const Exercise& exercise, const Function& function, int tier,
                      const Paint& paint) {
    constexpr std::string_view kinds[] = {"A question", "The formula", "The code"};
    const auto index = static_cast<std::size_t>(std::clamp(tier, 1, hint_tiers) - 1);
    std::string text = fmt::format("{} in {}\n{} (hint {} of {}):\n\n", paint.strong(function.name),
                                   place_of(workspace, exercise, function), kinds[index], tier, hint_tiers);
    const bool is_code = index + 1 == hint_tiers;
    text += indented(is_code ? function.hints[index] : wrapped(function.hints[index], 0, paint.width - 4), "    ");
    text += '\n';
    if (tier < hint_tiers)
        text += fmt::format("The next hint: {}\n", command_line(workspace, fmt::format("hint {}", exercise.number)));
    return text;
}

}  // namespace glassbox::learn
