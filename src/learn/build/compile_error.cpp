#include "learn/build/compile_error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <fstream>
#include <iterator>
#include <set>
#include <string_view>
#include <utility>

#include "learn/build/headers.hpp"
#include "learn/build/meant.hpp"
#include "learn/build/plain_words.hpp"
#include "learn/build/source_text.hpp"
#include "learn/build/unclosed.hpp"
#include "scene/printable.hpp"
#include "scene/suggestion.hpp"
#include "scene/text_file.hpp"

namespace glassbox::learn {
namespace {

namespace fs = std::filesystem;

/// A line of compiler output that names a place: "file:line:column: rest", "In file included from file:line,".
struct Located {
    Place place;
    std::string rest;
};

std::size_t number_at(std::string_view& text) {
    std::size_t number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc{}) return 0;
    text.remove_prefix(static_cast<std::size_t>(end - text.data()));
    return number;
}

/// Returns the place that a line names, if any. File names may contain colons, so the name ends at the first colon that
/// is followed by a number and another colon or comma.
std::optional<Located> located(std::string_view line) {
    for (const std::string_view opening : {"In file included from ", "                 from "})
        if (line.starts_with(opening)) line.remove_prefix(opening.size());
    for (std::size_t colon = line.find(':'); colon != std::string_view::npos; colon = line.find(':', colon + 1)) {
        std::string_view rest = line.substr(colon + 1);
        const std::size_t number = number_at(rest);
        if (number == 0 || rest.empty() || (rest[0] != ':' && rest[0] != ',')) continue;
        Located found{{std::string(line.substr(0, colon)), number, 0}, ""};
        rest.remove_prefix(1);
        found.place.column = number_at(rest);
        if (found.place.column > 0 && rest.starts_with(':')) rest.remove_prefix(1);
        rest.remove_prefix(std::min(rest.find_first_not_of(' '), rest.size()));
        found.rest = rest;
        return found;
    }
    return {};
}

/// One error with the places that led to it: files that include its file, templates that needed it.
struct Diagnosed {
    Located error;
    std::vector<Place> led_there;
};

std::vector<Diagnosed> diagnosed(const std::string& text) {
    std::vector<Diagnosed> errors;
    std::vector<Place> before;
    for (const std::string_view line : lines_of(text)) {
        std::optional<Located> found = located(line);
        if (!found) continue;
        std::string& rest = found->rest;
        constexpr std::string_view severity = "error: ";
        if (rest.starts_with(severity) || rest.starts_with("fatal error: ")) {
            rest.erase(0, rest.find(severity) + severity.size());
            errors.push_back({*std::move(found), std::exchange(before, {})});
            continue;
        }
        if (rest.starts_with("warning: ")) continue;
        // g++ prints how it got to an error before the error, clang++ after it, in a note. Other notes are ignored.
        const bool note = rest.starts_with("note: ");
        const bool needed =
            rest.find("requested here") != std::string::npos || rest.find("in call to") != std::string::npos;
        if (!note) before.push_back(found->place);
        else if (needed && !errors.empty()) errors.back().led_there.push_back(found->place);
    }
    return errors;
}

bool lies_in(const fs::path& file, const fs::path& folder) {
    if (folder.empty()) return false;
    const fs::path near = file.lexically_normal().lexically_relative(folder.lexically_normal());
    return !near.empty() && *near.begin() != "..";
}

bool lies_in(const fs::path& file, const std::vector<fs::path>& folders) {
    return std::ranges::any_of(folders, [&](const fs::path& folder) { return lies_in(file, folder); });
}

/// Whether a file may be read to show the line of an error. A line such as '#line 1 "/home/teacher/notes"' can name any
/// file; only the learner's own headers, ours and the system's are shown.
bool may_be_read(const fs::path& file, const OwnHeaders& mine, const fs::path& root) {
    std::error_code failed;
    const fs::path real = fs::canonical(file, failed);
    if (failed || !fs::is_regular_file(real, failed)) return false;
    std::vector<fs::path> folders{"/usr/include", "/usr/lib"};
    for (const fs::path& own : mine.folders) folders.push_back(fs::weakly_canonical(own, failed));
    for (const char* ours : {"src", "tests", "lessons"})
        if (!root.empty()) folders.push_back(fs::weakly_canonical(root / ours, failed));
    return lies_in(real, folders);
}

std::string line_of(const fs::path& file, std::size_t number) {
    std::ifstream in(file);
    std::string line;
    for (std::size_t n = 0; n < number; ++n)
        if (!std::getline(in, line)) return "";
    if (line.size() > 400) line.resize(400);
    return line;
}

/// For a compilation that ended without an error message: the compiler itself came to an abnormal end.
CompileError of_the_compiler_itself(const Outcome& outcome) {
    CompileError error;
    error.message = "the compiler: " + how_it_ended(outcome);
    switch (outcome.end) {
        case End::deadline:
            error.plain =
                "The compiler does not come to an end: does a file include itself or another one that never ends, or "
                "does a template need itself?";
            break;
        case End::memory:
        case End::signal:
            error.plain =
                "The compiler ran out of memory or crashed: does something in your file repeat without end, such as a "
                "template that needs itself, or an include of something that is no source file?";
            break;
        case End::output:
            error.plain = "The compiler has more to complain about than anyone can read: is this a C++ header at all?";
            break;
        default:
            break;
    }
    return error;
}

std::string first_line_with(const std::string& text, std::string_view part) {
    for (const std::string_view line : lines_of(text))
        if (line.find(part) != std::string_view::npos) return std::string(line);
    return "";
}

/// A message of the system when it cannot write, in the C locale's words, and what would help.
struct Hindrance {
    std::string_view words, remedy;
    bool is_of_reading_too = false;  ///< reading a file may fail for the same reason
};
constexpr std::string_view other_places = "name another folder with --folder, and for the compiler's own with TMPDIR";
constexpr std::array hindrances{
    Hindrance{"No space left on device", "free some space there, and where temporary files are made"},
    Hindrance{"Disk quota exceeded", "delete some files of yours, or ask for more space"},
    Hindrance{"Read-only file system", other_places},
    Hindrance{"Input/output error", "look at that disk"},
    Hindrance{"Permission denied", other_places, true},
    Hindrance{"Operation not permitted", other_places, true},
    Hindrance{"Too many open files", "close other programs", true},
};

/// Throws Error if a compiler or a linker reports that the system does not let it write. Skips quoted source lines: a
/// learner's line may contain any words.
void check_machine(const Outcome& outcome, const std::vector<fs::path>& mine, const fs::path& folder) {
    if (outcome.well() || outcome.end == End::stopped) return;
    for (const std::string_view line : lines_of(outcome.errors)) {
        if (line.starts_with(' ')) continue;  // a line of source
        const std::optional<Located> found = located(line);
        if (found && lies_in(folder / found->place.file, mine)) continue;
        for (const auto& [words, remedy, is_of_reading_too] : hindrances) {
            const std::string_view said = line.substr(0, line.find_last_not_of("'.\r ") + 1);
            const auto tells_of = [&](std::string_view what) { return line.find(what) != std::string_view::npos; };
            if (!said.ends_with(words)) continue;
            if (is_of_reading_too && !tells_of("creat") && !tells_of("writ") && !tells_of("output")) continue;
            throw Error(
                fmt::format("glassbox learn: error: the compiler cannot write what it makes: {} ({}); {}, and "
                            "try again",
                            words, found ? found->rest : std::string(line), remedy));
        }
    }
}

constexpr std::string_view what_to_do =
    "Run ./glassbox: it builds Glassbox anew, from its source as it is now. If it stays, please report it.";

/// Returns the operation whose operator stands where the error is.
OperatorInSource operation_at(const CompileError& error) {
    OperatorInSource operation;
    const std::size_t at = error.place.column - 1;
    const std::string_view source = error.source;
    constexpr std::string_view signs = "+-*/^|&<>=!", doubled = "|&=";
    if (error.place.column == 0 || at >= source.size() || signs.find(source[at]) == std::string_view::npos)
        return operation;
    const bool is_doubled = at + 1 < source.size() && doubled.find(source[at + 1]) != std::string_view::npos;
    operation.sign = source.substr(at, is_doubled ? 2 : 1);
    std::string_view left = source.substr(0, at), right = source.substr(at + operation.sign.size());
    left = left.substr(0, left.find_last_not_of(' ') + 1);
    right.remove_prefix(std::min(right.find_first_not_of(' '), right.size()));
    const std::size_t before = length_of_operand(left, true), after = length_of_operand(right, false);
    if (before > 0) operation.left = left.substr(left.size() - before);
    if (after > 0) operation.right = right.substr(0, after);
    return operation;
}

bool is_word_of(std::string_view text, std::string_view word) {
    const auto goes_on = [&](std::size_t i) { return i < text.size() && in_a_word(text[i]); };
    for (std::size_t at = text.find(word); at != std::string_view::npos; at = text.find(word, at + 1))
        if (!goes_on(at - 1) && !goes_on(at + word.size())) return true;
    return false;
}

/// The message without a name that the compiler suggests, if it is none of ours or the learner's: of <unistd.h> and
/// the like it knows many that nobody means.
std::string without_strangers(std::string message, const std::vector<fs::path>& headers) {
    constexpr std::string_view opening = "; did you mean '";
    const std::size_t at = message.find(opening);
    const bool is_undeclared = message.find("was not declared in this scope") != std::string::npos ||
                               message.starts_with("use of undeclared identifier");
    if (at == std::string::npos || !is_undeclared) return message;
    const std::string_view rest = std::string_view(message).substr(at + opening.size());
    const std::string name(rest.substr(0, rest.find('\'')));
    if (name.find("::") != std::string::npos) return message;
    for (const fs::path& folder : headers)
        for (const fs::path& file : headers_in(folder))
            if (is_word_of(content_of(file), name)) return message;
    return message.substr(0, at);
}

/// Returns a suggestion for an unknown name, if the file contains a similar one.
std::string suggested(const CompileError& error) {
    for (const std::string_view opening : {"use of undeclared identifier '", "there are no arguments to '", "'"}) {
        if (!error.message.starts_with(opening)) continue;
        const std::string_view rest = std::string_view(error.message).substr(opening.size());
        const std::string name(rest.substr(0, rest.find('\'')));
        if (opening == "'" && rest.find("was not declared in this scope") == std::string_view::npos) return "";
        std::ifstream in(error.place.file);
        const std::string text{std::istreambuf_iterator<char>(in), {}};
        std::set<std::string, std::less<>> names;
        std::string word;
        for (const char c : text + ' ') {
            if (std::isalnum(static_cast<unsigned char>(c)) || c == '_') word += c;
            else if (word.size() > 1 && word != name) names.insert(std::exchange(word, ""));
            else word.clear();
        }
        // People who mistype a name mostly get its beginning right.
        std::vector<std::string_view> known;
        for (const std::string& one : names)
            if (one[0] == name[0]) known.push_back(one);
        if (known.empty()) known.assign(names.begin(), names.end());
        const std::string words = known.empty() || name.size() < 2 ? "" : suggestion(name, known);
        return words.starts_with("did you mean") ? "Nothing is called " + name + " here; " + words : "";
    }
    return "";
}

/// Whether the compiler misses a semicolon where a statement has more ( than ) so far.
bool lacks_parenthesis(const CompileError& error) {
    if (error.message.find("xpected ';'") == std::string::npos) return false;
    const auto ends_statement = [](std::string_view line) {
        const std::size_t last = line.find_last_not_of(" \t\r");
        return last == std::string_view::npos || line[0] == '#' ||
               std::string_view(";{}").find(line[last]) != std::string_view::npos;
    };
    std::string statement = error.source.substr(0, error.place.column);
    for (std::size_t line = error.place.line; line-- > 1;) {
        const std::string before = line_of(error.place.file, line);
        if (ends_statement(before)) break;
        statement.insert(0, before + '\n');
    }
    return std::ranges::count(statement, '(') > std::ranges::count(statement, ')');
}

/// Returns what members there are, where one is asked for that is not; "" for any other error.
std::string of_members(const CompileError& error, const std::vector<fs::path>& headers) {
    const auto quoted_after = [&](std::string_view opening) {
        const std::size_t at = error.message.find(opening);
        if (at == std::string::npos) return std::string();
        const std::string rest = error.message.substr(at + opening.size());
        return rest.substr(0, rest.find('\''));
    };
    const bool is_gcc = error.message.find("' has no member named '") != std::string::npos;
    const std::string member = quoted_after(is_gcc ? "' has no member named '" : "no member named '");
    std::string type = quoted_after(is_gcc ? "'" : "' in '");
    if (member.empty() || type.empty()) return "";
    type = type.substr(0, type.find('<'));
    type = type.substr(type.find_last_of(": ") == std::string::npos ? 0 : type.find_last_of(": ") + 1);
    const std::vector<std::string> members = members_of(type, headers);
    return members.empty() ? "" : fmt::format("A {} has no member {}: it has {}.", type, member, enumerated(members));
}

/// Returns the words for an include of something that a later lesson introduces.
std::string of_a_later_lesson(const CompileError& error, const fs::path& root) {
    std::string name;
    if (const std::size_t end = error.message.find(": No such file"); end != std::string::npos)
        name = error.message.substr(0, end);
    else if (error.message.starts_with("'") && error.message.ends_with("' file not found"))
        name = error.message.substr(1, error.message.rfind('\'') - 1);
    if (name.empty()) return "";
    std::vector<std::string> headers;
    std::error_code none;
    for (const fs::directory_entry& lesson : fs::directory_iterator(root / "src/core", none)) {
        for (const fs::directory_entry& header : fs::directory_iterator(lesson.path(), none)) {
            headers.push_back(header.path().filename().string());
            if (headers.back() == name)
                return fmt::format("{} belongs to lesson {}; this lesson does without it: take the include away.", name,
                                   lesson.path().filename().string());
        }
    }
    const std::vector<std::string_view> known(headers.begin(), headers.end());
    const std::string words = known.empty() ? "" : suggestion(name, known);
    return words.starts_with("did you mean") ? fmt::format("There is no header {}; {}", name, words) : "";
}

/// These files and those of the learner's that they include, each after what it includes.
std::vector<fs::path> read_with(const std::vector<fs::path>& headers, const std::vector<fs::path>& folders) {
    std::vector<fs::path> files;
    const std::function<void(const fs::path&)> read = [&](const fs::path& path) {
        const fs::path file = path.lexically_normal();
        const std::string text = content_of(file);
        if (text.empty() || !lies_in(file, folders) || std::ranges::find(files, file) != files.end()) return;
        files.push_back(file);
        const std::size_t place = files.size() - 1;
        for (const std::string_view line : lines_of(text)) {
            const std::size_t open = line.find_first_of("<\"");
            if (line.find("#include") == std::string_view::npos || open == std::string_view::npos) continue;
            const std::string_view name = line.substr(open + 1, line.find_first_of(">\"", open + 1) - open - 1);
            read(file.parent_path() / name);
            for (const fs::path& folder : folders) read(folder / name);
        }
        std::rotate(files.begin() + static_cast<std::ptrdiff_t>(place),
                    files.begin() + static_cast<std::ptrdiff_t>(place) + 1, files.end());
    };
    for (const fs::path& header : headers) read(header);
    return files;
}

/// Returns what is not closed in one of the learner's files, unless the compiler found the error that it reports
/// before: in that file, or in one that it includes.
std::optional<CompileError> not_closed(const OwnHeaders& mine, const CompileError& told) {
    for (const fs::path& file : read_with(mine.included, mine.folders)) {
        const std::optional<Unclosed> found = unclosed_in(content_of(file));
        if (!found) continue;
        const bool is_told = told.place.file == file.string();
        const std::vector<fs::path> before = read_with({file}, mine.folders);
        const bool is_found_before = std::ranges::find(before, fs::path(told.place.file)) != before.end();
        if (is_told ? std::pair(told.place.line, told.place.column) < std::pair(found->line, found->column)
                    : is_found_before)
            continue;
        CompileError error;
        error.place = {file.string(), found->line, found->column};
        error.yours = true;
        error.source = line_of(file, found->line);
        error.plain = found->words;
        error.others = told.others + 1;
        return error;
    }
    return {};
}

/// Returns the error at a line that calls cos_sin with a Turn, where one of the errors has led to such a line: the
/// others are of what was made of it.
std::optional<CompileError> without_degrees(const std::vector<Diagnosed>& errors, const OwnHeaders& mine) {
    for (const Diagnosed& one : errors) {
        std::vector<Place> places = one.led_there;
        places.push_back(one.error.place);
        for (const Place& place : places) {
            if (!lies_in(place.file, mine.folders)) continue;
            CompileError error;
            error.plain = takes_degrees(content_of(place.file), place.line);
            if (error.plain.empty()) continue;
            error.place = place;
            error.yours = true;
            error.source = line_of(place.file, place.line);
            error.message = in_our_names(one.error.rest);
            error.others = static_cast<int>(errors.size()) - 1;
            return error;
        }
    }
    return {};
}

}  // namespace

std::optional<CompileError> compile_error(const Outcome& compilation, const OwnHeaders& mine, const fs::path& folder) {
    if (compilation.well()) return {};
    check_machine(compilation, mine.folders, folder);
    std::vector<Diagnosed> errors = diagnosed(compilation.errors);
    if (compilation.end != End::exited || errors.empty()) {
        CompileError error = of_the_compiler_itself(compilation);
        if (errors.empty()) return error;
        if (compilation.end == End::stopped) return error;
    }
    for (Diagnosed& one : errors) {
        one.error.place.file = (folder / one.error.place.file).lexically_normal().string();
        for (Place& place : one.led_there) place.file = (folder / place.file).lexically_normal().string();
    }
    const auto is_mine = [&](const Place& place) { return lies_in(place.file, mine.folders); };

    const Diagnosed* chosen = &errors.front();
    Place place = chosen->error.place;
    const auto own =
        std::find_if(errors.begin(), errors.end(), [&](const Diagnosed& one) { return is_mine(one.error.place); });
    if (own != errors.end()) {
        chosen = &*own;
        place = own->error.place;
    } else {
        for (const Diagnosed& one : errors) {
            const auto via = std::find_if(one.led_there.begin(), one.led_there.end(), is_mine);
            if (via == one.led_there.end()) continue;
            chosen = &one;
            place = *via;
            break;
        }
    }
    CompileError error;
    error.place = place;
    error.yours = is_mine(place);
    error.message = in_our_names(chosen->error.rest);
    std::vector<fs::path> headers = mine.folders;
    headers.push_back(folder / "src/core");
    if (may_be_read(place.file, mine, folder)) {
        error.source = line_of(place.file, place.line);
        error.plain = meant(error, headers);
        if (error.plain.empty()) error.plain = suggested(error);
    }
    if (error.plain.empty()) error.plain = of_a_later_lesson(error, folder);
    if (error.plain.empty()) error.plain = of_members(error, headers);
    if (error.plain.empty() && error.yours && lacks_parenthesis(error))
        error.plain = "A ( is not closed: its ) is missing before this.";
    if (error.plain.empty())
        error.plain = in_plain_words(without_strangers(error.message, headers), operation_at(error));
    if (!error.yours && error.plain.empty())
        error.plain =
            "The tests cannot use your headers as they are: has each function the name, the parameters and the result "
            "that it had in the starter?";
    error.others = static_cast<int>(errors.size()) - 1;
    if (std::optional<CompileError> cause = without_degrees(errors, mine)) return cause;
    if (std::optional<CompileError> cause = not_closed(mine, error)) return cause;
    return error;
}

std::optional<CompileError> link_error(const Outcome& linking) {
    if (linking.well()) return {};
    check_machine(linking, {}, {});
    CompileError error;
    const std::string undefined = first_line_with(linking.errors, "undefined reference to ");
    const std::string twice = first_line_with(linking.errors, "multiple definition of ");
    if (linking.end == End::exited && !undefined.empty()) {
        error.message = undefined.substr(undefined.find("undefined reference to "));
        error.plain = "A function is declared, but has no body: is a ; there where its { should be?";
    } else if (linking.end == End::exited && !twice.empty()) {
        error.message = twice.substr(twice.find("multiple definition of "));
        error.plain = "Two things have this name: rename yours.";
    } else {
        error.message = "the linker: " + how_it_ended(linking);
    }
    return error;
}

CompileError with_its_cause(CompileError error, const std::function<std::optional<CompileError>()>& with_ours) {
    if (error.yours) return error;
    std::optional<CompileError> ours = with_ours();
    if (!ours) return error;
    ours->ours = true;
    ours->plain = fmt::format("This is no mistake of yours: with our own headers it is the same. {}", what_to_do);
    return *std::move(ours);
}

Error error_in_ours(const Outcome& compilation, const fs::path& source) {
    if (compilation.end == End::deadline)
        return error_at(
            {source.string()},
            fmt::format("cannot be compiled: it takes more than {:g} s; is this machine busy with something "
                        "else? Try again when it is not",
                        std::chrono::duration<double>(compilation.limits.time).count()));
    const std::optional<CompileError> error = compile_error(compilation, {}, {});
    if (!error || error->place.file.empty())
        return error_at({source.string()},
                        fmt::format("cannot be compiled: {}. {}", how_it_ended(compilation), what_to_do));
    return error_at(error->place,
                    fmt::format("cannot be compiled: {}. This is no mistake of yours. {}", error->message, what_to_do));
}

}  // namespace glassbox::learn
