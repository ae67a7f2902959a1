#include "viewer/ui/widgets/theme.hpp"

namespace glassbox {

namespace {

// Okabe and Ito's colours, "Color Universal Design" (2008), which people with any colour vision can tell apart; the
// darker ones of a pair are for light backgrounds.
constexpr Palette on_dark{
    .passed = IM_COL32(0, 190, 140, 255),
    .failed = IM_COL32(240, 110, 40, 255),
    .warning = IM_COL32(240, 200, 60, 255),
    .accent = IM_COL32(86, 180, 233, 255),
    .second = IM_COL32(225, 140, 190, 255),
    .text = IM_COL32(235, 235, 235, 255),
    .faint_text = IM_COL32(165, 165, 170, 255),
    .canvas = IM_COL32(28, 28, 32, 255),
    .line = IM_COL32(90, 90, 98, 255),
    .a = IM_COL32(86, 180, 233, 255),
    .b = IM_COL32(230, 159, 0, 255),
    .c = IM_COL32(225, 140, 190, 255),
    .keyword = IM_COL32(140, 195, 255, 255),
    .number = IM_COL32(240, 190, 120, 255),
    .string = IM_COL32(160, 215, 150, 255),
    .comment = IM_COL32(180, 180, 186, 255),
    .box = IM_COL32(230, 159, 0, 255),
};
constexpr Palette on_light{
    .passed = IM_COL32(0, 120, 90, 255),
    .failed = IM_COL32(190, 70, 0, 255),
    .warning = IM_COL32(150, 105, 0, 255),
    .accent = IM_COL32(0, 100, 170, 255),
    .second = IM_COL32(170, 60, 130, 255),
    .text = IM_COL32(20, 20, 22, 255),
    .faint_text = IM_COL32(95, 95, 100, 255),
    .canvas = IM_COL32(240, 240, 242, 255),
    .line = IM_COL32(140, 140, 148, 255),
    .a = IM_COL32(0, 100, 170, 255),
    .b = IM_COL32(165, 105, 0, 255),
    .c = IM_COL32(170, 60, 130, 255),
    .keyword = IM_COL32(0, 60, 150, 255),
    .number = IM_COL32(120, 60, 0, 255),
    .string = IM_COL32(20, 90, 30, 255),
    .comment = IM_COL32(80, 80, 86, 255),
    .box = IM_COL32(165, 105, 0, 255),
};

}  // namespace

Palette apply_theme(const Appearance& appearance, float text_size) {
    ImGuiStyle style;
    if (appearance.dark) ImGui::StyleColorsDark(&style);
    else ImGui::StyleColorsLight(&style);
    const Palette& palette = appearance.dark ? on_dark : on_light;
    style.Colors[ImGuiCol_Text] = ImGui::ColorConvertU32ToFloat4(palette.text);
    style.Colors[ImGuiCol_TextDisabled] = ImGui::ColorConvertU32ToFloat4(palette.faint_text);
    style.Colors[ImGuiCol_WindowBg] = ImGui::ColorConvertU32ToFloat4(palette.canvas);
    style.Colors[ImGuiCol_ChildBg] = ImVec4(0, 0, 0, 0);
    style.Colors[ImGuiCol_PopupBg] = appearance.dark ? ImVec4(.15f, .15f, .17f, .98f) : ImVec4(1, 1, 1, .98f);
    style.FrameRounding = style.GrabRounding = style.TabRounding = 3;
    style.WindowRounding = 0;
    style.PopupRounding = style.ChildRounding = 4;
    style.FrameBorderSize = appearance.dark ? 0.f : 1.f;
    style.ScaleAllSizes(text_size / 18);
    ImGui::GetStyle() = style;
    return palette;
}

}  // namespace glassbox
