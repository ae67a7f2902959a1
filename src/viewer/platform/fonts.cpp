#include "viewer/platform/fonts.hpp"

#include <backends/imgui_impl_opengl3.h>

#include <span>

#include "output/font.hpp"
#include "viewer/platform/mono_font.hpp"

namespace glassbox {
namespace {

// First and last character of each block that we use; the fonts lack some of these characters. Newer versions of Dear
// ImGui need no list.
constexpr ImWchar characters[] = {0x0020, 0x017F,  // Latin
                                  0x02B0, 0x036F,  // letters as modifiers, combining accents
                                  0x0370, 0x03FF,  // Greek
                                  0x1D2C, 0x1D6A,  // raised and lowered letters
                                  0x2010, 0x205E,  // punctuation
                                  0x2070, 0x209C,  // superscripts and subscripts
                                  0x2100, 0x214F,  // letterlike
                                  0x2190, 0x22FF,  // arrows, mathematical operators
                                  0x2300, 0x23FF,  // technical: ⌂, ⏎, brackets in pieces
                                  0x2500, 0x25FF,  // box drawing, blocks, geometric shapes: ─ ▒ ▶ ◀ ● ◆
                                  0x2610, 0x2612,  // ☐ ☑ ☒
                                  0x26A0, 0x26A0,  // ⚠
                                  0x2713, 0x2718,  // ✓ ✗
                                  0x27E8, 0x27EB,  // ⟨ ⟩
                                  0xFFFD, 0xFFFD,  // stands for an invalid byte
                                  0};

ImFont* add_font(std::span<const unsigned char> file, float size) {
    ImFontConfig config;
    config.FontDataOwnedByAtlas = false;  // it is part of the program, and only read: hence the const_cast
    config.OversampleH = size < 24 ? 3 : 2;
    config.OversampleV = 1;
    config.PixelSnapH = false;
    auto* bytes = const_cast<unsigned char*>(file.data());
    return ImGui::GetIO().Fonts->AddFontFromMemoryTTF(bytes, static_cast<int>(file.size()), size, &config, characters);
}

}  // namespace

Fonts load_fonts(float size) {
    ImGuiIO& io = ImGui::GetIO();
#if IMGUI_VERSION_NUM < 19200
    // The renderer has kept a texture of all characters since its first frame. Newer versions update theirs themselves.
    const bool drawn = io.Fonts->TexID != ImTextureID{};
    if (drawn) ImGui_ImplOpenGL3_DestroyFontsTexture();
#else
    ImGui::GetStyle().FontSizeBase = size;
#endif
    io.Fonts->Clear();
    const Fonts fonts{add_font(font_file(), size), add_font(mono_font_file(), size)};
    io.FontDefault = fonts.text;
#if IMGUI_VERSION_NUM < 19200
    if (drawn) ImGui_ImplOpenGL3_CreateFontsTexture();
#endif
    return fonts;
}

}  // namespace glassbox
