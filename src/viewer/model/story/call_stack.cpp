#include "viewer/model/story/call_stack.hpp"

#include <algorithm>

#include "explain/words.hpp"
#include "scene/text_file.hpp"
#include "viewer/model/story/functions.hpp"

namespace glassbox {

namespace {

/// The functions of a header of the core. They are read from its text once.
std::span<const SourceFunction> functions_in(const SourceFile& file) {
    static const std::vector<std::vector<SourceFunction>> all = [] {
        std::vector<std::vector<SourceFunction>> read;
        for (const SourceFile& header : core_sources()) read.push_back(functions_of(header));
        return read;
    }();
    return all[static_cast<std::size_t>(&file - core_sources().data())];
}

SourceFunction function_on(const SourceFile& file, std::size_t line) {
    for (const SourceFunction& function : functions_in(file))
        if (line >= function.first && line <= function.last) return function;
    return {};
}

const SourceFile* header_named(std::string_view name) {
    for (const SourceFile& file : core_sources())
        if (file.path.ends_with(name) && file.path.substr(0, file.path.size() - name.size()).ends_with('/'))
            return &file;
    return nullptr;
}

/// The line on which a function calls an operator of vectors; without a line if it may be one of several.
StackLine calls_operator(CallNumber number, const Call& call, const SourceFunction& made) {
    StackLine line{number, call.function, header_named(call.header), 0};
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
    if (!event.place) return stack;
    const std::span<const Call> calls = calls_of(story, *event.place);
    const Step& step = tape_of(story, *event.place)[event.place->step].step;
    const std::vector<CallNumber> around = calls_around(story, *event.place);
    const auto add = [&](CallNumber in, const char* path, int number) {
        const SourceFile* const file = find_source(source(path));
        if (!file) return stack.clear();  // a line outside of the core: the stack begins with the core's
        const auto line = static_cast<std::size_t>(number);
        stack.push_back({in, function_on(*file, line).name, file, line});
    };
    for (const CallNumber call : around) add(calls[call].caller, calls[call].file, calls[call].line);
    const SourceFile* const file = find_source(source(step.file));
    if (!file) return {};
    const auto line = static_cast<std::size_t>(step.line);
    const SourceFunction made = function_on(*file, line);
    if (made.name.starts_with("operator") && !around.empty())
        stack.push_back(calls_operator(around.back(), calls[around.back()], made));
    stack.push_back({around.empty() ? 0 : around.back(), made.name, file, line});
    return stack;
}

std::string_view code_of(const StackLine& line) {
    if (!line.file || line.line == 0) return {};
    const std::vector<std::string_view> text = lines(*line.file);
    return line.line <= text.size() ? trimmed(text[line.line - 1]) : std::string_view();
}

}  // namespace glassbox
