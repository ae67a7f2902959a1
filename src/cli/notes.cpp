#include "cli/notes.hpp"

#include <fmt/format.h>

#include "cli/tell.hpp"
#include "render/search/build_engine.hpp"

namespace glassbox {

namespace {

bool typed(const CLI::App& command, const std::string& option) {
    const CLI::Option* found = command.get_option_no_throw(option);
    return found && found->count() > 0;
}

struct Use {
    const char* option;
    int first_stage;
    bool only_for_pictures;
};

constexpr Use uses[] = {
    {"--size", 1, true},    {"--sphere", 2, false},  {"--triangle", 3, false}, {"--ambient", 4, true},
    {"--diffuse", 4, true}, {"--specular", 4, true}, {"--exponent", 4, true},  {"--shading", 4, true},
    {"--turn", 5, true},    {"--light", 4, true},    {"--intensity", 4, true}, {"--accumulated", 5, true},
};

}  // namespace

void note(const CLI::App& command, const std::string& text, const std::vector<std::string>& about) {
    if (!about.empty())
        tell(fmt::format("glassbox {}: note: {}: {}", command.get_name(), text, fmt::join(about, ", ")));
}

std::vector<std::string> unused_options(const CLI::App& command, Rays rays, const Options& options) {
    std::vector<std::string> unused;
    for (const auto& [option, first_stage, only_for_pictures] : uses) {
        if (!typed(command, option)) continue;
        if (only_for_pictures && rays == Rays::of_ones_own)
            unused.push_back(fmt::format("{} (only for pictures)", option));
        else if (options.stage < first_stage) unused.push_back(fmt::format("{} (from stage {})", option, first_stage));
    }
    if (options.engine == EngineChoice::fast && !engine_can(options))
        unused.push_back("--engine fast (only for certified answers, not by the rules tolerance and levental-2014)");
    return unused;
}

}  // namespace glassbox
