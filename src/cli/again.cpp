#include "cli/again.hpp"

#include <algorithm>

#include "explain/shell_word.hpp"

namespace glassbox {

std::string options_again(const CLI::App& command, const std::vector<std::string_view>& without) {
    std::string options;
    for (const CLI::Option* option : command.get_options()) {
        const std::string name = option->get_lnames().empty() ? std::string() : option->get_lnames().front();
        if (option->count() == 0 || option->get_positional() || std::ranges::count(without, name) > 0) continue;
        options += " --" + name;
        if (option->get_expected_max() > 0) options += ' ' + shell_word(option->results().front());
    }
    return options;
}

}  // namespace glassbox
