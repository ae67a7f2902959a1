#include "viewer/model/story/call_stack.hpp"

#include <algorithm>

#include "scene/text_file.hpp"
#include "viewer/model/story/functions.hpp"

namespace glassbox {

namespace {

/// The functions of a header. Those of the core are read from its text once.
std::vector<SourceFunction> functions_in(const SourceFile& file) {
    static const std::vector<std::vector<SourceFunction>> all = [] {
        std::vector<std::vector<SourceFunction>> read;
        for (const SourceFile& header : core_sources()) read.push_back(functions_of(header));
        return read;
    }();
    for (std::size_t i = 0; i < all.size(); ++i)
        if (&core_sources()[i] == &file) return all[i];
    return functions_of(file);
}

SourceFunction function_on(const SourceFile& file, std::size_t line) {
    for (const SourceFunction& function : functions_in(file))
        if (line >= function.first && line <= function.last) return function;
    return {};
}

/// The line on which a function calls an operator of vectors; without a line if it may be one of several.
StackLine calls_operator(const Story& story, CallNumber number, const Call& call, const SourceFunction& made) {
    StackLine line{number, call.function, find_header(story, call.header), 0};
    if (!line.file) return line;
    for (const SourceFunction& function : functions_in(*line.file))
        if (function.name == call.function) {
            constexpr std::size_t word = std::string_view("operator").size();
            line.line = only_line_with(*line.file, function, std::string_view(made.name).substr(word), made.is_unary);
            break;
        }
    return line;
}

}  // namespace

std::vector<StackLine> call_stack(const Story& story, const Event& event) {
    std::vector<StackLine> stack;
    const std::optional<StepPlace>& place = event.place ? event.place : event.stopped_after;
    if (!place) return stack;
    const std::span<const Call> calls = calls_of(story, *place);
    const Step& step = tape_of(story, *place)[place->step].step;
    const std::vector<CallNumber> around = calls_around(story, *place);
    const auto add = [&](CallNumber in, const char* path, int number) {
        const SourceFile* const file = find_source(story, path);
        if (!file) return stack.clear();  // a line outside of the core: the stack begins with the core's
        const auto line = static_cast<std::size_t>(number);
        stack.push_back({in, function_on(*file, line).name, file, line});
    };
    for (const CallNumber call : around) add(calls[call].caller, calls[call].file, calls[call].line);
    const SourceFile* const file = find_source(story, step.file);
    if (!file) return {};
    const auto line = static_cast<std::size_t>(step.line);
    const SourceFunction made = function_on(*file, line);
    if (made.name.starts_with("operator") && !around.empty())
        stack.push_back(calls_operator(story, around.back(), calls[around.back()], made));
    stack.push_back({around.empty() ? 0 : around.back(), made.name, file, line});
    return stack;
}

std::string_view code_of(const StackLine& line) {
    if (!line.file || line.line == 0) return {};
    const std::vector<std::string_view> text = lines(*line.file);
    return line.line <= text.size() ? trimmed(text[line.line - 1]) : std::string_view();
}

}  // namespace glassbox
