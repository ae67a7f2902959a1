#include "learn/report/page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/archive/iterators/base64_from_binary.hpp>
#include <boost/archive/iterators/transform_width.hpp>
#include <string_view>

#include "output/png.hpp"
#include "scene/printable.hpp"
#include "scene/utf8.hpp"

namespace glassbox::learn {

namespace {

constexpr std::string_view style = R"(
:root { color-scheme: light dark; --line: #8888; --good: #0072b2; --bad: #c04a00; --faint: #777; }
@media (prefers-color-scheme: dark) { :root { --good: #56b4e9; --bad: #ff9d5c; --faint: #aaa; } }
body { font: 18px/1.5 system-ui, "DejaVu Sans", sans-serif; max-width: 62em; margin: 2em auto; padding: 0 1em; }
h1 { margin-top: 2em; } h2 { margin-top: 1.6em; border-top: 2px solid var(--line); padding-top: .4em; }
table { border-collapse: collapse; } th, td { border: 1px solid var(--line); padding: .25em .7em; text-align: left; }
pre { border-left: .3em solid var(--bad); padding: .4em 1em; overflow-x: auto; font-size: 16px; }
.good { color: var(--good); font-weight: bold; } .bad { color: var(--bad); font-weight: bold; } .faint { color: var(--faint); }
.pictures { display: flex; gap: 1em; flex-wrap: wrap; } figure { margin: 0; } img { max-width: 19em; border: 1px solid var(--line); }
@media print { h1 { page-break-before: always; } h1:first-of-type { page-break-before: auto; } }
)";

/// Escapes text, so that nothing in it is read as HTML.
std::string escaped(std::string_view text) {
    std::string result;
    for (const char c : text) {
        switch (c) {
            case '&':
                result += "&amp;";
                break;
            case '<':
                result += "&lt;";
                break;
            case '>':
                result += "&gt;";
                break;
            case '"':
                result += "&quot;";
                break;
            default:
                result += c;
        }
    }
    return result;
}

/// RFC 4648.
std::string base64(const std::vector<std::byte>& bytes) {
    using namespace boost::archive::iterators;
    using Digits = base64_from_binary<transform_width<const char*, 6, 8>>;
    const char* const begin = reinterpret_cast<const char*>(bytes.data());
    std::string text(Digits(begin), Digits(begin + bytes.size()));
    text.append((3 - bytes.size() % 3) % 3, '=');
    return text;
}

std::string figure(const Image& image, const std::string& caption) {
    return fmt::format(
        "<figure><img alt=\"{0}\" src=\"data:image/png;base64,{1}\"><figcaption>{0}</figcaption></figure>\n",
        escaped(caption), base64(png(image)));
}

/// Orange where the pictures differ; elsewhere ours, darkened, for orientation.
Image difference(const Image& mine, const Image& ours) {
    Image result(ours.width, ours.height);
    const auto dark = [](std::uint8_t channel) { return static_cast<std::uint8_t>(channel / 4); };
    for (std::size_t k = 0; k < result.pixels.size(); ++k) {
        const auto [red, green, blue] = ours.pixels[k];
        result.pixels[k] =
            mine.pixels[k] == ours.pixels[k] ? Rgb{dark(red), dark(green), dark(blue)} : Rgb{255, 140, 0};
    }
    return result;
}

std::string pictures(const LessonStanding& lesson) {
    std::string html;
    if (!lesson.no_picture.empty()) html += fmt::format("<p>No picture: {}.</p>\n", escaped(lesson.no_picture));
    html += "<div class=\"pictures\">\n";
    if (lesson.mine) html += figure(*lesson.mine, "the learner’s");
    if (lesson.ours) html += figure(*lesson.ours, "ours");
    if (const auto count = pixels_differing(lesson)) {
        const std::size_t all = lesson.ours->pixels.size();
        const std::string caption = *count == 0 ? std::string("no pixel differs")
                                                : fmt::format("{} of {} pixels differ, {:.1f} % (orange)", *count, all,
                                                              100.0 * *count / static_cast<double>(all));
        html += figure(difference(*lesson.mine, *lesson.ours), caption);
    }
    return html + "</div>\n";
}

std::string marked(const FunctionStanding& function) {
    switch (function.state) {
        case State::passed:
            return "<span class=\"good\">✓ passed</span>";
        case State::failing:
            return "<span class=\"bad\">✗ fails</span>";
        case State::not_written:
            return "<span class=\"faint\">· not written</span>";
        case State::waiting:
            return fmt::format("<span class=\"faint\">… waits for {}</span>", escaped(function.waits_for));
        default:
            return "<span class=\"faint\">– not reached</span>";
    }
}

std::string words_for(Grade grade) {
    switch (grade) {
        case Grade::passed:
            return "passed";
        case Grade::unfinished:
            return "unfinished";
        case Grade::failing:
            return "failing";
        case Grade::does_not_compile:
            return "does not compile";
        default:
            return "not begun";
    }
}

std::string marked(Grade grade) {
    const bool bad = grade == Grade::failing || grade == Grade::does_not_compile;
    const auto [kind, mark] = grade == Grade::passed       ? std::pair("good", "✓")
                              : bad                        ? std::pair("bad", "✗")
                              : grade == Grade::unfinished ? std::pair("faint", "…")
                                                           : std::pair("faint", "–");
    return fmt::format("<span class=\"{}\">{} {}</span>", kind, mark, words_for(grade));
}

int hints_of(const LessonStanding& lesson) {
    int hints = 0;
    for (const auto& function : lesson.functions) hints += function.hints;
    return hints;
}

std::string counted(int number, std::string_view one, std::string_view many) {
    return fmt::format("{} {}", number, number == 1 ? one : many);
}

std::string section(const LessonStanding& lesson) {
    std::string html = fmt::format("<h2>{}. {} {}</h2>\n", lesson.number, escaped(lesson.title), marked(lesson.grade));
    if (lesson.grade == Grade::not_begun) return html;
    html += fmt::format("<p>{} of {} functions, {} of {} tests{}; tested {}, {} shown{}.</p>\n",
                        functions_passed(lesson), lesson.functions.size(), lesson.cases_passed, lesson.cases,
                        lesson.cases_waiting > 0 ? fmt::format(" ({} for a function to be written)",
                                                               counted(lesson.cases_waiting, "waits", "wait"))
                                                 : "",
                        counted(lesson.runs, "time", "times"), counted(hints_of(lesson), "hint", "hints"),
                        lesson.gave_up ? "; <b>gave up</b>: the solution was shown before the tests passed" : "");
    html += "<table><tr><th>function</th><th>in</th><th>tests</th><th>hints</th></tr>\n";
    for (const FunctionStanding& function : lesson.functions)
        html += fmt::format("<tr><td>{}</td><td>{}</td><td>{}</td><td>{}</td></tr>\n", escaped(function.name),
                            escaped(function.header), marked(function), function.hints);
    html += "</table>\n";
    if (!lesson.wrong.empty())
        html += fmt::format("<h3>{}</h3>\n<pre>{}</pre>\n",
                            lesson.grade == Grade::unfinished ? "What comes next" : "What is wrong first",
                            escaped(lesson.wrong));
    if (!lesson.mistake.empty()) html += fmt::format("<p><b>It looks like this:</b> {}</p>\n", escaped(lesson.mistake));
    if (!lesson.description.empty())
        html += fmt::format("<p><b>What the checks show:</b> {}</p>\n", escaped(lesson.description));
    return html + pictures(lesson);
}

/// One lesson in a table: "✓", "3/5", "✗ 3/5" where it does not compile, "–".
std::string cell(const LessonStanding& lesson) {
    if (lesson.grade == Grade::passed) return lesson.gave_up ? "✓ (gave up)" : "✓";
    if (lesson.grade == Grade::not_begun) return "–";
    if (lesson.grade == Grade::does_not_compile) return "✗";
    return fmt::format("{}/{}", functions_passed(lesson), lesson.functions.size());
}

int lessons_passed(const LearnerStanding& learner) {
    return static_cast<int>(
        std::ranges::count(learner.lessons, Grade::passed, [](const auto& lesson) { return lesson.grade; }));
}

constexpr std::string_view legend =
    "✓ passed; 3/5: three of five functions; ✗ does not compile; – not begun; gave up: the solution was shown before.";

std::string html_table(const std::vector<LearnerStanding>& learners) {
    std::string html = "<h1 id=\"all\">All</h1>\n<table><tr><th>learner</th>";
    for (const auto& lesson : learners.front().lessons)
        html += fmt::format("<th>{}. {}</th>", lesson.number, escaped(lesson.title));
    html += "<th>passed</th><th>hints</th></tr>\n";
    for (std::size_t k = 0; k < learners.size(); ++k) {
        html += fmt::format("<tr><td><a href=\"#learner-{}\">{}</a></td>", k, escaped(learners[k].learner));
        int hints = 0;
        for (const auto& lesson : learners[k].lessons) {
            html += fmt::format("<td>{}</td>", cell(lesson));
            hints += hints_of(lesson);
        }
        html += fmt::format("<td>{}</td><td>{}</td></tr>\n", lessons_passed(learners[k]), hints);
    }
    return html + fmt::format("</table>\n<p class=\"faint\">{}</p>\n", legend);
}

/// Quotes a field where CSV requires it (RFC 4180).
std::string field(const std::string& text) {
    if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
    std::string quoted = "\"";
    for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
    return quoted + '"';
}

}  // namespace

std::string to_html(const std::vector<LearnerStanding>& learners, const std::string& remark) {
    std::string html = fmt::format(
        "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">"
        "<meta name=\"viewport\" content=\"width=device-width\">\n<title>Glassbox: "
        "{}</title>\n<style>{}</style></head><body>\n",
        learners.size() == 1 ? escaped(learners.front().learner)
                             : counted(static_cast<int>(learners.size()), "learner", "learners"),
        style);
    if (learners.size() > 1) html += "<p><a href=\"#all\">To the table of all</a></p>\n";
    for (std::size_t k = 0; k < learners.size(); ++k) {
        html += fmt::format("<h1 id=\"learner-{}\">{}</h1>\n<p>{} of {} lessons passed.</p>\n", k,
                            escaped(learners[k].learner), lessons_passed(learners[k]), learners[k].lessons.size());
        for (const std::string& note : learners[k].notes) html += fmt::format("<p>{}</p>\n", escaped(note));
        for (const auto& lesson : learners[k].lessons) html += section(lesson);
    }
    if (learners.size() > 1) html += html_table(learners);
    if (!remark.empty()) html += fmt::format("<p class=\"faint\">{}</p>\n", escaped(remark));
    return html + "</body></html>\n";
}

std::string to_table(const std::vector<LearnerStanding>& learners) {
    std::vector<std::vector<std::string>> rows(1, {"learner"});
    if (!learners.empty())
        for (const auto& lesson : learners.front().lessons)
            rows[0].push_back(fmt::format("{} {}", lesson.number, lesson.title));
    for (const auto& learner : learners) {
        rows.push_back({printable(learner.learner)});
        for (const auto& lesson : learner.lessons) rows.back().push_back(cell(lesson));
    }
    std::vector<std::size_t> widths;
    for (const auto& row : rows) {
        widths.resize(std::max(widths.size(), row.size()));
        for (std::size_t k = 0; k < row.size(); ++k) widths[k] = std::max(widths[k], columns(row[k]));
    }
    std::string text;
    for (const auto& row : rows) {
        std::string line;
        for (std::size_t k = 0; k < row.size(); ++k) {
            line += row[k];
            if (k + 1 < row.size()) line.append(widths[k] - columns(row[k]) + 2, ' ');
        }
        text += line + '\n';
    }
    return text + fmt::format("{}\n", legend);
}

std::string to_csv(const std::vector<LearnerStanding>& learners) {
    std::string text =
        "learner,lesson,verdict,functions_passed,functions,tests_passed,tests_waiting,tests,pixels_differing,hints,"
        "runs,"
        "gave_up\n";
    for (const auto& learner : learners) {
        for (const auto& lesson : learner.lessons) {
            const auto differing = pixels_differing(lesson);
            text += fmt::format("{},{},{},{},{},{},{},{},{},{},{},{}\n", field(learner.learner), lesson.number,
                                words_for(lesson.grade), functions_passed(lesson), lesson.functions.size(),
                                lesson.cases_passed, lesson.cases_waiting, lesson.cases,
                                differing ? fmt::to_string(*differing) : "", hints_of(lesson), lesson.runs,
                                lesson.gave_up ? "yes" : "no");
        }
    }
    return text;
}

}  // namespace glassbox::learn
