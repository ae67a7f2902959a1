#include <sstream>

#include "scene/error.hpp"
#include "viewer/script/commands.hpp"
#include "viewer/script/script.hpp"

namespace glassbox::script {

namespace {

/// The same command; what goes wrong when it is run is told with its place in the script, too.
Command told_with(const Place& place, Command command) {
    auto* const changes = std::get_if<ChangeState>(&command);
    if (!changes) return command;
    return ChangeState{[place, change = changes->change](ViewerState& state, const Results& results) {
        try {
            change(state, results);
        } catch (const Error& error) {
            throw error_at(place, error.what());
        }
    }};
}

}  // namespace

std::vector<Command> read(const std::string& text, const std::string& file) {
    std::vector<Command> commands;
    std::istringstream lines(text);
    std::string line;
    for (std::size_t number = 1; std::getline(lines, line); ++number) {
        if (line.ends_with('\r')) line.pop_back();
        const Place place{file, number, line.find_first_not_of(" \t") + 1};
        try {
            const Words words = words_of(line);
            if (!words.empty()) commands.push_back(told_with(place, command_of(words)));
        } catch (const Error& error) {
            throw error_at(place, error.what());
        }
    }
    return commands;
}

}  // namespace glassbox::script
