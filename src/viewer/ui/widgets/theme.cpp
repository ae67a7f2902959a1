#include "viewer/ui/widgets/theme.hpp"

#include <utility>

namespace glassbox {

namespace {

// Okabe and Ito's colours, "Color Universal Design" (2008), which people with any colour vision can tell apart; the
// darker ones of a pair are for light backgrounds.
constexpr Palette on_dark{
    .passed = IM_COL32(0, 200, 150, 255),
    .failed = IM_COL32(255, 140, 80, 255),
    .warning = IM_COL32(240, 200, 60, 255),
    .accent = IM_COL32(86, 180, 233, 255),
    .second = IM_COL32(230, 150, 198, 255),
    .text = IM_COL32(235, 235, 235, 255),
    .faint_text = IM_COL32(175, 175, 180, 255),
    .canvas = IM_COL32(28, 28, 32, 255),
    .line = IM_COL32(90, 90, 98, 255),
    .a = IM_COL32(86, 180, 233, 255),
    .b = IM_COL32(230, 159, 0, 255),
    .c = IM_COL32(230, 150, 198, 255),
    .n_l = IM_COL32(240, 200, 60, 255),
    .n_r = IM_COL32(86, 180, 233, 255),
    .n_h = IM_COL32(190, 155, 255, 255),
    .keyword = IM_COL32(140, 195, 255, 255),
    .number = IM_COL32(240, 190, 120, 255),
    .string = IM_COL32(160, 215, 150, 255),
    .comment = IM_COL32(180, 180, 186, 255),
    .box = IM_COL32(230, 159, 0, 255),
};
constexpr Palette on_light{
    .passed = IM_COL32(0, 95, 70, 255),
    .failed = IM_COL32(155, 52, 0, 255),
    .warning = IM_COL32(115, 80, 0, 255),
    .accent = IM_COL32(0, 82, 145, 255),
    .second = IM_COL32(145, 45, 110, 255),
    .text = IM_COL32(20, 20, 22, 255),
    .faint_text = IM_COL32(80, 80, 85, 255),
    .canvas = IM_COL32(240, 240, 242, 255),
    .line = IM_COL32(140, 140, 148, 255),
    .a = IM_COL32(0, 82, 145, 255),
    .b = IM_COL32(120, 76, 0, 255),
    .c = IM_COL32(145, 45, 110, 255),
    .n_l = IM_COL32(115, 80, 0, 255),
    .n_r = IM_COL32(0, 82, 145, 255),
    .n_h = IM_COL32(95, 45, 165, 255),
    .keyword = IM_COL32(0, 60, 150, 255),
    .number = IM_COL32(120, 60, 0, 255),
    .string = IM_COL32(20, 85, 30, 255),
    .comment = IM_COL32(80, 80, 86, 255),
    .box = IM_COL32(120, 76, 0, 255),
};

/// What text lies on. Each text of the palette keeps a contrast of 4.5 to 1 to all of these but a button's, and plain
/// text to these, too (WCAG 2.2, 1.4.3).
struct Grounds {
    ImU32 popup, frame, frame_hovered, frame_active, row, row_hovered, row_active, button, button_hovered,
        button_active;
};
constexpr Grounds dark_grounds{
    .popup = IM_COL32(38, 38, 43, 250),
    .frame = IM_COL32(41, 45, 54, 255),
    .frame_hovered = IM_COL32(36, 58, 88, 255),
    .frame_active = IM_COL32(34, 60, 94, 255),
    .row = IM_COL32(34, 50, 74, 255),
    .row_hovered = IM_COL32(32, 60, 95, 255),
    .row_active = IM_COL32(20, 58, 100, 255),
    .button = IM_COL32(41, 74, 122, 255),
    .button_hovered = IM_COL32(45, 95, 158, 255),
    .button_active = IM_COL32(15, 105, 190, 255),
};
constexpr Grounds light_grounds{
    .popup = IM_COL32(255, 255, 255, 250),
    .frame = IM_COL32(255, 255, 255, 255),
    .frame_hovered = IM_COL32(208, 222, 240, 255),
    .frame_active = IM_COL32(200, 216, 238, 255),
    .row = IM_COL32(212, 224, 240, 255),
    .row_hovered = IM_COL32(200, 216, 238, 255),
    .row_active = IM_COL32(196, 214, 238, 255),
    .button = IM_COL32(190, 206, 228, 255),
    .button_hovered = IM_COL32(160, 190, 225, 255),
    .button_active = IM_COL32(120, 170, 230, 255),
};

void set_grounds(ImGuiStyle& style, const Grounds& grounds) {
    const std::pair<ImGuiCol, ImU32> colors[] = {
        {ImGuiCol_PopupBg, grounds.popup},
        {ImGuiCol_FrameBg, grounds.frame},
        {ImGuiCol_FrameBgHovered, grounds.frame_hovered},
        {ImGuiCol_FrameBgActive, grounds.frame_active},
        {ImGuiCol_Header, grounds.row},
        {ImGuiCol_HeaderHovered, grounds.row_hovered},
        {ImGuiCol_HeaderActive, grounds.row_active},
        {ImGuiCol_Button, grounds.button},
        {ImGuiCol_ButtonHovered, grounds.button_hovered},
        {ImGuiCol_ButtonActive, grounds.button_active},
        {ImGuiCol_TitleBg, grounds.row},
        {ImGuiCol_TitleBgActive, grounds.row},
    };
    for (const auto& [which, color] : colors) style.Colors[which] = ImGui::ColorConvertU32ToFloat4(color);
}

}  // namespace

ImU32 color_of(const Palette& palette, story::Mark mark) {
    return mark == story::Mark::right ? palette.passed : mark == story::Mark::wrong ? palette.failed : palette.warning;
}

Palette apply_theme(const Appearance& appearance, float text_size) {
    ImGuiStyle style;
    if (appearance.dark) ImGui::StyleColorsDark(&style);
    else ImGui::StyleColorsLight(&style);
    const Palette& palette = appearance.dark ? on_dark : on_light;
    style.Colors[ImGuiCol_Text] = ImGui::ColorConvertU32ToFloat4(palette.text);
    style.Colors[ImGuiCol_TextDisabled] = ImGui::ColorConvertU32ToFloat4(palette.faint_text);
    style.Colors[ImGuiCol_WindowBg] = ImGui::ColorConvertU32ToFloat4(palette.canvas);
    style.Colors[ImGuiCol_ChildBg] = ImVec4(0, 0, 0, 0);
    set_grounds(style, appearance.dark ? dark_grounds : light_grounds);
    style.FrameRounding = style.GrabRounding = style.TabRounding = 3;
    style.WindowRounding = 0;
    style.PopupRounding = style.ChildRounding = 4;
    style.FrameBorderSize = appearance.dark ? 0.f : 1.f;
    style.ScaleAllSizes(text_size / 18);
    ImGui::GetStyle() = style;
    return palette;
}

}  // namespace glassbox
