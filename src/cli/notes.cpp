#include "cli/notes.hpp"

#include <fmt/format.h>

#include <utility>

#include "cli/tell.hpp"

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
    {"--size", 1, true},     {"--sphere", 2, false}, {"--triangle", 3, false},
    {"--ambient", 4, true},  {"--diffuse", 4, true}, {"--specular", 4, true},
    {"--exponent", 4, true}, {"--shading", 4, true}, {"--turn", 5, true},
};

/// The stage that first computes a measurement.
int first_stage(std::string_view measurement) {
    constexpr std::pair<std::string_view, int> stages[] = {
        {"depth", 2}, {"normal", 2}, {"discriminant", 2}, {"side", 3},    {"n.l", 4},
        {"n.h", 4},   {"n.v", 4},    {"ambient", 4},      {"diffuse", 4}, {"specular", 4},
    };
    for (const auto& [name, stage] : stages)
        if (name == measurement) return stage;
    return 1;
}

}  // namespace

void note(const CLI::App& command, const std::string& text, const std::vector<std::string>& about) {
    if (!about.empty())
        tell(fmt::format("glassbox {}: note: {}: {}", command.get_name(), text, fmt::join(about, ", ")));
}

std::vector<std::string> unused_options(const CLI::App& command, Rays rays, int stage) {
    std::vector<std::string> unused;
    for (const auto& [option, first_stage, only_for_pictures] : uses) {
        if (!typed(command, option)) continue;
        if (only_for_pictures && rays == Rays::of_ones_own)
            unused.push_back(fmt::format("{} (only for pictures)", option));
        else if (stage < first_stage) unused.push_back(fmt::format("{} (from stage {})", option, first_stage));
    }
    return unused;
}

std::string why_no_value(const Measurement& what, const Scene& scene, const Options& options) {
    if (const int stage = first_stage(what.name); options.stage < stage) return fmt::format("from stage {}", stage);
    if (what.name == "n.h" && scene.shading.model == ShadingModel::phong) return "phong has no half vector";
    if (what.name == "side" && std::holds_alternative<MoellerTrumbore>(options.triangle_rule))
        return "moeller-trumbore has no side products";
    if (what.name == "side") return "no triangle was tested";
    if (what.name == "discriminant") return "no sphere was tested";
    return "no ray meets a surface";
}

}  // namespace glassbox
