#include "learn/picture/written.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

#include "scene/error.hpp"
#include "scene/suggestion.hpp"

namespace glassbox::learn::mine {
namespace {

std::string without_comments(std::string_view text) {
    std::string code;
    for (;;) {
        const std::size_t comment = std::min(text.find("//"), text.find("/*"));
        code += text.substr(0, comment);
        if (comment == std::string_view::npos) return code;
        const bool is_line = text[comment + 1] == '/';
        text.remove_prefix(comment + 2);
        const std::size_t end = text.find(is_line ? "\n" : "*/");
        if (end == std::string_view::npos) return code;
        text.remove_prefix(is_line ? end : end + 2);
    }
}

/// Returns the text between two others that follow `from`; "" if they do not.
std::string_view between(std::string_view text, std::size_t from, std::string_view open, std::string_view close) {
    const std::size_t begin = text.find(open, from);
    if (begin == std::string_view::npos) return "";
    text.remove_prefix(begin + open.size());
    const std::size_t end = text.find(close);
    return end == std::string_view::npos ? "" : text.substr(0, end);
}

/// Returns what a lesson lacks; "" if nothing is left to write.
std::string lacking(const Workspace& workspace, const Exercise& exercise) {
    for (const std::string& header : exercise.headers) {
        const std::string file = "its file " + header;
        try {
            const std::string code = without_comments(read_header(workspace, exercise, header));
            const std::size_t stub = code.find("not_written<");
            if (stub == std::string::npos) continue;
            const std::string_view name = between(code, stub, "(\"", "\")");
            return name.empty() ? file : fmt::format("`{}`", name);
        } catch (const Error&) {  // it is not there, or cannot be read
            return file;
        }
    }
    return "";
}

/// "lesson 2"; "lessons 1, 2 and 4".
std::string numbered(const Lessons& lessons) {
    std::vector<std::string> numbers;
    for (const Exercise* const exercise : lessons) numbers.push_back(std::to_string(exercise->number));
    return (lessons.size() == 1 ? "lesson " : "lessons ") + enumerated(numbers);
}

}  // namespace

Lessons drawing_in_double(const Workspace& workspace) {
    Lessons lessons;
    for (const Exercise& exercise : workspace.exercises)
        if (exercise.own_picture == OwnPicture::in_double) lessons.push_back(&exercise);
    return lessons;
}

Written written_in(const Workspace& workspace) {
    Written written;
    const Lessons lessons = drawing_in_double(workspace);
    std::error_code none;
    for (const Exercise* const exercise : lessons) {
        if (!std::filesystem::is_directory(workspace.headers_of(*exercise), none)) continue;
        std::string lacks = lacking(workspace, *exercise);
        if (lacks.empty()) written.finished.push_back(exercise);
        else written.begun.push_back({exercise, std::move(lacks)});
    }
    written.is_all = written.finished.size() == lessons.size();
    return written;
}

std::string in_words(const Written& written, const Workspace& workspace) {
    std::string waiting;
    for (const auto& [exercise, waits_for] : written.begun)
        waiting += fmt::format("; lesson {} waits for {}", exercise->number, waits_for);
    if (!written.finished.empty())
        return fmt::format("drawn by {} of yours{}{}", numbered(written.finished), waiting,
                           written.is_all ? "" : "; the rest is ours");
    if (!written.begun.empty())
        return fmt::format("no lesson of yours is finished yet{}; '{} learn test {}' says what comes next", waiting,
                           workspace.program, written.begun.front().exercise->number);
    return fmt::format("no lesson of yours is begun yet; '{} learn test' makes the files that you write",
                       workspace.program);
}

}  // namespace glassbox::learn::mine
