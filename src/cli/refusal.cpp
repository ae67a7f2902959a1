#include "cli/refusal.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "scene/suggestion.hpp"

namespace glassbox {

namespace {

using Names = std::vector<std::string>;

/// "-o", "--out": all names of an option.
Names names_of(const CLI::Option& option) {
    Names names;
    for (const std::string& name : option.get_snames()) names.push_back("-" + name);
    for (const std::string& name : option.get_lnames()) names.push_back("--" + name);
    return names;
}

Names option_names(const CLI::App& command) {
    Names names;
    for (const CLI::Option* option : command.get_options())
        for (const std::string& name : names_of(*option)) names.push_back(name);
    return names;
}

bool has(const Names& names, const std::string& name) {
    return std::find(names.begin(), names.end(), name) != names.end();
}

Names command_names(const CLI::App& program) {
    Names names;
    for (const CLI::App* command : program.get_subcommands([](const CLI::App*) { return true; }))
        names.push_back(command->get_name());
    return names;
}

/// "'render', 'measure', 'shoot'".
std::string listed(const Names& names) { return fmt::format("'{}'", fmt::join(names, "', '")); }

/// The message for an option without a value, which took the next option for one.
std::string option_without_value(const CLI::App& command) {
    const Names known = option_names(command);
    for (const CLI::Option* option : command.get_options())
        for (const std::string& value : option->results())
            if (has(known, value))
                return fmt::format("{}: a value is missing before {}; write {} {}", option->get_name(), value,
                                   option->get_name(), option->get_type_name());
    return "";
}

std::string option_given_twice(const CLI::App& command) {
    for (const CLI::Option* option : command.get_options())
        if (option->get_items_expected_max() > 0 &&  // no flag: flags take no value
            option->count() > static_cast<std::size_t>(option->get_items_expected_max()))
            return fmt::format("{}: given {} times; give it once", option->get_name(), option->count());
    return "";
}

/// The message for a word that is neither an option of this command nor a value of one.
std::string stray_word(const CLI::App& command) {
    Names words = command.remaining();
    words.erase(std::remove(words.begin(), words.end(), "--"), words.end());
    if (words.empty()) return "";
    const auto option = std::find_if(words.begin(), words.end(),
                                     [](const std::string& word) { return word.size() > 1 && word[0] == '-'; });
    if (option == words.end()) return fmt::format("'{}' is one word too many", words.front());
    const std::string name = option->substr(0, option->find_first_of("= "));
    if (has(option_names(command), name)) return fmt::format("'{}' is one word; write it as two", *option);
    const std::string near = name.size() > 2 ? did_you_mean(name, option_names(command)) : "";
    return fmt::format("{} is not an option{}", name, near.empty() ? "" : "; " + near);
}

std::string missing_option(const CLI::App& command) {
    for (const CLI::Option* option : command.get_options())
        if (option->get_required() && option->count() == 0)
            return fmt::format("{} is missing: {}", option->get_name(), option->get_description());
    return "";
}

std::string missing_value(const CLI::App& command, const CLI::ParseError& error) {
    if (error.get_exit_code() != static_cast<int>(CLI::ExitCodes::ArgumentMismatch)) return "";
    const std::string text = error.what();
    const CLI::Option* option = command.get_option_no_throw(text.substr(0, text.find(':')));
    if (!option) return "";
    return fmt::format("{}: a value is missing; write {} {}", option->get_name(), option->get_name(),
                       option->get_type_name());
}

/// The message for a command line without a command, or with another word in the command's place.
std::string command_missing(const CLI::App& program, const std::string& called) {
    const Names commands = command_names(program);
    const Names words = program.remaining();
    if (words.empty()) return fmt::format("a command is missing; it must be one of {}", listed(commands));
    const std::string& word = words.front();
    for (const CLI::App* command : program.get_subcommands([](const CLI::App*) { return true; }))
        if (has(option_names(*command), word))
            return fmt::format("{} must follow the command, as in '{} {} {}'", word, called, command->get_name(), word);
    if (word[0] == '-') return stray_word(program);
    const std::string near = did_you_mean(word, commands);
    return fmt::format("'{}' is no command; {}", word, near.empty() ? "it must be one of " + listed(commands) : near);
}

std::string in_command(const CLI::App& command, const CLI::ParseError& error) {
    for (const std::string& found : {option_without_value(command), option_given_twice(command), stray_word(command)})
        if (!found.empty()) return found;
    const bool required = error.get_exit_code() == static_cast<int>(CLI::ExitCodes::RequiredError);
    const std::string missing = required ? missing_option(command) : missing_value(command, error);
    return missing.empty() ? error.what() : missing;
}

}  // namespace

std::string refusal(const CLI::App& program, const CLI::ParseError& error) {
    const CLI::App* command = &program;  // the innermost one that the line names
    std::string name = "glassbox";
    while (command->remaining_size() == 0 && !command->get_subcommands().empty()) {
        command = command->get_subcommands().front();
        name += ' ' + command->get_name();
    }
    const bool lacks_command = command->get_subcommands().empty() && !command_names(*command).empty();
    const bool in_program = command == &program || (lacks_command && command->remaining_size() > 0);
    const std::string what = in_program ? command_missing(*command, name) : in_command(*command, error);
    const std::string see = what.ends_with('?') ? "" : fmt::format("; see '{} --help'", name);
    return fmt::format("{}: error: {}{}", name, what, see);
}

}  // namespace glassbox
