#pragma once
#include <shading.hpp>

#include "scene/named.hpp"

namespace glassbox {

inline constexpr NameTable<ShadingModel, 3> shading_models{{
    {"phong", ShadingModel::phong, "the highlight where the mirrored light meets the eye"},
    {"blinn-phong", ShadingModel::blinn_phong, "the highlight where n is half way from light to eye"},
    {"levental-2014", ShadingModel::levental_2014, "as the paper's program: L not of length 1, bytes cut"},
}};

constexpr std::string_view name_of(ShadingModel model) {
    return name_where(shading_models, [&](ShadingModel one) { return one == model; });
}

}  // namespace glassbox
