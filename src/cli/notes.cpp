#include "cli/notes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

#include "cli/tell.hpp"
#include "render/parameters.hpp"
#include "render/search/build_engine.hpp"

namespace glassbox {

namespace {

bool typed(const CLI::App& command, const std::string& option) {
    const CLI::Option* found = command.get_option_no_throw(option);
    return found && found->count() > 0;
}

struct Use {
    std::string option;
    int first_stage;
    bool only_for_pictures;
};

/// In the order in which they are told: by stages, but the turns before the light.
std::vector<Use> uses() {
    std::vector<Use> all{{"--size", 1, true}};
    for (const Parameter& parameter : parameters())
        all.push_back({fmt::format("--{}", parameter.name), parameter.first_stage, parameter.only_for_pictures});
    std::stable_sort(all.begin(), all.end(), [](const Use& a, const Use& b) { return a.first_stage < b.first_stage; });
    const auto place_of = [&](std::string_view option) {
        return std::find_if(all.begin(), all.end(), [&](const Use& use) { return use.option == option; });
    };
    const auto turn = place_of("--turn");
    std::rotate(place_of("--light"), turn, turn + 1);
    return all;
}

}  // namespace

void note(const CLI::App& command, const std::string& text, const std::vector<std::string>& about) {
    if (!about.empty())
        tell(fmt::format("glassbox {}: note: {}: {}", command.get_name(), text, fmt::join(about, ", ")));
}

std::vector<std::string> unused_options(const CLI::App& command, Rays rays, const Options& options) {
    std::vector<std::string> unused;
    for (const auto& [option, first_stage, only_for_pictures] : uses()) {
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
