#include "render/why_no_value.hpp"

#include <fmt/format.h>

#include <utility>

namespace glassbox {

namespace {

/// The stage that first computes a measurement.
int first_stage(std::string_view measurement) {
    constexpr std::pair<std::string_view, int> stages[] = {
        {"depth", 2}, {"normal", 2},  {"discriminant", 2}, {"side", 3},     {"n.l", 4},   {"n.h", 4},
        {"n.v", 4},   {"ambient", 4}, {"diffuse", 4},      {"specular", 4}, {"nodes", 2}, {"boxes-missed", 2},
    };
    for (const auto& [name, stage] : stages)
        if (name == measurement) return stage;
    return 1;
}

}  // namespace

std::string why_no_value(const Measurement& what, ShadingModel model, const Options& options) {
    if (const int stage = first_stage(what.name); options.stage < stage) return fmt::format("from stage {}", stage);
    if (what.name == "n.h" && model == ShadingModel::phong) return "phong has no half vector";
    if (what.name == "side" && std::holds_alternative<MoellerTrumbore>(options.triangle_rule))
        return "moeller-trumbore has no side products";
    if (what.name == "side") return "no triangle was tested";
    if (what.name == "discriminant") return "no sphere was tested";
    if (what.needs.boxes) return "boxes are the fast engine's, and that answers certified";
    return "no ray meets a surface";
}

}  // namespace glassbox
