// Can all text be read? Contrast as in WCAG 2.2, 1.4.3: (L1 + 0.05) / (L2 + 0.05) of relative luminances, at least 4.5.
#include "viewer/ui/widgets/theme.hpp"

#include <doctest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

using namespace glassbox;

namespace {

double luminance(const ImVec4& c) {
    const auto linear = [](float value) {
        return value <= 0.04045f ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
    };
    return 0.2126 * linear(c.x) + 0.7152 * linear(c.y) + 0.0722 * linear(c.z);
}

/// What is seen of a colour that lies over another.
ImVec4 over(const ImVec4& top, const ImVec4& ground) {
    const auto mixed = [&](float a, float b) { return top.w * a + (1 - top.w) * b; };
    return {mixed(top.x, ground.x), mixed(top.y, ground.y), mixed(top.z, ground.z), 1};
}

double contrast(const ImVec4& a, const ImVec4& b) {
    const auto [least, greatest] = std::minmax({luminance(a), luminance(b)});
    return (greatest + 0.05) / (least + 0.05);
}

}  // namespace

TEST_CASE("contrast is measured rightly") {
    // White on black is (1 + 0.05) / (0 + 0.05) = 21. Grey 118 of 255 has L = ((118/255 + 0.055)/1.055)^2.4 = 0.1812,
    // so black on it has 0.2312 / 0.05 = 4.62.
    CHECK(contrast({1, 1, 1, 1}, {0, 0, 0, 1}) == doctest::Approx(21));
    const float grey = 118 / 255.f;
    CHECK(contrast({0, 0, 0, 1}, {grey, grey, grey, 1}) == doctest::Approx(4.62).epsilon(.005));
}

TEST_CASE("all text has a contrast of at least 4.5 to all that it may lie on, hovered rows, too") {
    ImGui::CreateContext();
    for (const bool dark : {true, false}) {
        const Palette palette = apply_theme({dark, 18}, 18);
        const ImVec4 canvas = ImGui::ColorConvertU32ToFloat4(palette.canvas);
        const auto ground = [&](ImGuiCol which) { return over(ImGui::GetStyle().Colors[which], canvas); };
        const std::pair<const char*, ImU32> inks[] = {
            {"text", palette.text},
            {"faint text", palette.faint_text},
            {"passed", palette.passed},
            {"failed", palette.failed},
            {"warning", palette.warning},
            {"accent", palette.accent},
            {"second", palette.second},
            {"a", palette.a},
            {"b", palette.b},
            {"c", palette.c},
            {"n·l", palette.n_l},
            {"n·r", palette.n_r},
            {"n·h", palette.n_h},
            {"keyword", palette.keyword},
            {"number", palette.number},
            {"string", palette.string},
            {"comment", palette.comment},
            {"box", palette.box},
        };
        for (const ImGuiCol which :
             {ImGuiCol_WindowBg, ImGuiCol_PopupBg, ImGuiCol_FrameBg, ImGuiCol_FrameBgHovered, ImGuiCol_FrameBgActive,
              ImGuiCol_Header, ImGuiCol_HeaderHovered, ImGuiCol_HeaderActive, ImGuiCol_TitleBg, ImGuiCol_TitleBgActive})
            for (const auto& ink : inks) {
                CAPTURE(dark);
                CAPTURE(std::string(ink.first));
                CAPTURE(std::string(ImGui::GetStyleColorName(which)));
                CHECK(contrast(ImGui::ColorConvertU32ToFloat4(ink.second), ground(which)) >= 4.5);
            }
        for (const ImGuiCol which : {ImGuiCol_Button, ImGuiCol_ButtonHovered, ImGuiCol_ButtonActive})
            CHECK(contrast(ImGui::ColorConvertU32ToFloat4(palette.text), ground(which)) >= 4.5);
    }
    ImGui::DestroyContext();
}
