#include <doctest.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "viewer/platform/fonts.hpp"
#include "viewer/platform/offscreen.hpp"
#include "viewer/platform/texture.hpp"

using namespace glassbox;

namespace {

constexpr WindowSize small{320, 200};

/// What no window covers has the colour of windows: in these tests black.
void blacken() { ImGui::GetStyle().Colors[ImGuiCol_WindowBg] = {0, 0, 0, 1}; }

/// A frame's `draw` that fills the whole window with what `contents` says.
template <class Contents>
DrawFrame whole_window(Contents contents) {
    return [contents](const Input&) {
        ImGui::SetNextWindowPos({0, 0});
        ImGui::SetNextWindowSize(ImGui::GetIO().DisplaySize);
        ImGui::Begin("all", nullptr, ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoBackground);
        contents();
        ImGui::End();
        return 0.0;
    };
}

/// How many pixels inside the rectangle are not black, the background.
int inked(const Image& image, int left, int top, int right, int bottom) {
    int count = 0;
    for (int y = top; y < bottom; ++y)
        for (int x = left; x < right; ++x) count += image.at(x, y) != Rgb{};
    return count;
}

}  // namespace

TEST_CASE("a texture is drawn at its place, with hard edges between its pixels") {
    Offscreen screen(small);
    blacken();
    Texture texture;
    CHECK(texture.empty());
    const std::array<Rgba, 4> pixels{{{255, 0, 0}, {0, 255, 0}, {0, 0, 255}, {255, 255, 255}}};
    texture.fill(2, 2, pixels);
    CHECK(texture.width() == 2);
    screen.frame([&](const Input&) {
        ImGui::GetBackgroundDrawList()->AddImage(texture.id(), {10, 20}, {110, 120});
        return 0.0;
    });
    const Image image = screen.screenshot();
    REQUIRE(image.width == 320);
    REQUIRE(image.height == 200);
    // 2x2 over the square from (10, 20) to (110, 120): each pixel is 50 wide, so the edges lie at x = 60 and y = 70.
    int wrong = 0;
    for (int y = 0; y < 200; ++y)
        for (int x = 0; x < 320; ++x) {
            const bool inside = x >= 10 && x < 110 && y >= 20 && y < 120;
            const Rgba p = pixels[(x < 60 ? 0u : 1u) + (y < 70 ? 0u : 2u)];
            wrong += image.at(x, y) != (inside ? Rgb{p.red, p.green, p.blue} : Rgb{});
        }
    CHECK(wrong == 0);
    CHECK(screen.last_complaint() == "");
    CHECK(screen.complaints() == 0);
}

TEST_CASE("a texture can be filled again, with another size, too, and moved") {
    Offscreen screen(small);
    blacken();
    Texture first;
    const auto draw = [&](const Texture& texture) {
        screen.frame([&](const Input&) {
            ImGui::GetBackgroundDrawList()->AddImage(texture.id(), {0, 0}, {320, 200});
            return 0.0;
        });
        return screen.screenshot();
    };
    first.fill(1, 1, std::array<Rgba, 1>{{{1, 2, 3}}});
    CHECK(draw(first).at(5, 5) == Rgb{1, 2, 3});
    first.fill(1, 1, std::array<Rgba, 1>{{{4, 5, 6}}});
    CHECK(draw(first).at(5, 5) == Rgb{4, 5, 6});
    first.fill(2, 1, std::array<Rgba, 2>{{{7, 8, 9}, {10, 11, 12}}});
    const Texture second = std::move(first);
    const Image image = draw(second);
    CHECK(image.at(0, 100) == Rgb{7, 8, 9});
    CHECK(image.at(319, 100) == Rgb{10, 11, 12});
    CHECK(screen.complaints() == 0);
}

TEST_CASE("text is drawn where it should be, in both fonts, whose size can change between frames") {
    Offscreen screen(small);
    blacken();
    for (const float size : {16.0f, 32.0f}) {
        const Fonts fonts = load_fonts(size);
        for (ImFont* font : {fonts.text, fonts.mono}) {
            ImVec2 extent;
            screen.frame([&](const Input&) {
                const char* text = "(n·l)² ≥ √ε";
                extent = font->CalcTextSizeA(size, 1e6f, 0, text);
                ImGui::GetBackgroundDrawList()->AddText(font, size, {20, 30}, IM_COL32_WHITE, text);
                return 0.0;
            });
            CHECK(extent.y == size);
            const int right = 20 + static_cast<int>(std::ceil(extent.x));
            const int bottom = 30 + static_cast<int>(size);
            const Image image = screen.screenshot();
            const int inside = inked(image, 20, 30, right, bottom);
            // 11 characters of a line's height and about half as wide; letters cover a tenth to a half of their box
            CHECK(inside > 11 * size * size / 2 / 10);
            CHECK(inside < 11 * size * size / 2);
            CHECK(inked(image, right - static_cast<int>(size), 30, right, bottom) > 0);  // up to the last character
            const int edges = 2 * static_cast<int>(size);  // smoothed, they may lie outside
            CHECK(inked(image, 0, 0, small.width, small.height) <= inside + edges);
        }
    }
    CHECK(screen.last_complaint() == "");
    CHECK(screen.complaints() == 0);
}

TEST_CASE("both fonts have every sign that we write") {
    Offscreen screen(small);
    blacken();
    const Fonts fonts = load_fonts(16);
    screen.frame([](const Input&) { return 0.0; });
    const std::u32string signs =
        U"abcXYZ019{}~ üöŝ ·×÷−±√∞≤≥≠≈⊙⊗∈⊥∑∂∇⟨⟩ ⁰¹²³⁴⁵⁶⁷⁸⁹⁻₀₁₂₃₄₅₆₇₈₉ᵉ εΔπλμσθφω …–—‘’“”• ←↑→↓↔⇒↶↷ ─│┌┐└┘├┤┬┴┼ "
        U"█▒░ ■□▲△▶►▼◀◄◆◇○●◦ ⌂⏎ ☐☑☒⚠✓✗\uFFFD";
    for (const char32_t sign : signs) {
        INFO("U+", std::hex, static_cast<unsigned>(sign));
        for (ImFont* font : {fonts.text, fonts.mono}) {
#if IMGUI_VERSION_NUM >= 19200
            CHECK(font->IsGlyphInFont(static_cast<ImWchar>(sign)));
#else
            CHECK(font->FindGlyphNoFallback(static_cast<ImWchar>(sign)) != nullptr);
#endif
        }
    }
}

TEST_CASE("numbers in the mono font stand in columns") {
    Offscreen screen(small);
    blacken();
    ImFont* mono = load_fonts(15).mono;
    screen.frame([&](const Input&) {
        const float width = mono->CalcTextSizeA(15, 1e6f, 0, "11111111").x;
        for (const char* text : {"88888888", "-0.1e+17", "iiiiiiii", "√²≥ε·−₀Δ"})
            CHECK(mono->CalcTextSizeA(15, 1e6f, 0, text).x == doctest::Approx(width));
        return 0.0;
    });
}

TEST_CASE("the mouse arrives: a click presses a button, the wheel is told for one frame") {
    Offscreen screen(small);
    blacken();
    int clicks = 0;
    float wheel = 0;
    const DrawFrame draw = whole_window([&] {
        ImGui::SetCursorPos({100, 100});
        clicks += ImGui::InvisibleButton("here", {20, 20});
        wheel = ImGui::GetIO().MouseWheel;
    });
    const auto click_at = [&](float x, float y) {
        for (const bool down : {false, true, false}) screen.frame(draw, {.x = x, .y = y, .left = down});
    };
    screen.frame(draw);
    click_at(110, 110);
    CHECK(clicks == 1);
    click_at(90, 110);
    CHECK(clicks == 1);
    click_at(110, 119);
    CHECK(clicks == 2);
    screen.frame(draw, {.x = 110, .y = 110, .wheel = -2});
    CHECK(wheel == -2);
    screen.frame(draw, {.x = 110, .y = 110});
    CHECK(wheel == 0);
}

TEST_CASE("keys arrive: as they are, and typed into a text field") {
    Offscreen screen(small);
    blacken();
    std::array<char, 32> field{};
    Input seen;
    bool entered = false;
    const DrawFrame draw = [&](const Input& input) {
        seen = input;
        return whole_window([&] {
            if (ImGui::IsWindowAppearing()) ImGui::SetKeyboardFocusHere();
            entered = ImGui::InputText("field", field.data(), field.size(), ImGuiInputTextFlags_EnterReturnsTrue);
        })(input);
    };
    for (int frame = 0; frame < 3; ++frame) screen.frame(draw);
    CHECK(seen.keys.empty());
    CHECK(seen.time == doctest::Approx(3 / 60.0));

    const std::array<KeyPress, 4> typed{{{.key = Key::character, .character = U'x', .shift = true},
                                         {.key = Key::space},
                                         {.key = Key::character, .character = U'²'},
                                         {.key = Key::character, .character = U'y'}}};
    screen.frame(draw, {}, std::span(typed).first(1));
    CHECK(seen.keys == std::vector<KeyPress>{typed[0]});
    screen.frame(draw, {}, std::span(typed).subspan(1), 0.5);
    CHECK(seen.keys.size() == 3);
    CHECK(seen.time == doctest::Approx(4 / 60.0 + 0.5));
    CHECK(std::string(field.data()) == "X ²y");
    CHECK(!entered);

    const std::array<KeyPress, 1> home{{{.key = Key::home}}}, z{{{.key = Key::character, .character = U'z'}}};
    screen.frame(draw, {}, home);
    screen.frame(draw, {}, z);
    CHECK(std::string(field.data()) == "zX ²y");
    const std::array<KeyPress, 1> undo{{{.key = Key::character, .character = U'z', .control = true}}};
    screen.frame(draw, {}, undo);
    CHECK(std::string(field.data()) == "X ²y");
    const std::array<KeyPress, 1> enter{{{.key = Key::enter}}};
    screen.frame(draw, {}, enter);
    CHECK(entered);
}

TEST_CASE("a frame says how long it may stand, and has the size asked for") {
    Offscreen screen(small);
    blacken();
    const auto fill = [&] {
        return screen.frame([](const Input&) {
            const ImVec2 size = ImGui::GetIO().DisplaySize;
            ImGui::GetBackgroundDrawList()->AddRectFilled({0, 0}, size, IM_COL32(9, 8, 7, 255));
            ImGui::GetBackgroundDrawList()->AddRectFilled({0, 0}, {1, 1}, IM_COL32_WHITE);
            return 2.5;
        });
    };
    for (const WindowSize size : {WindowSize{320, 200}, {1024, 640}, {3840, 2160}, {1, 1}, {640, 33}}) {
        screen.resize(size);
        CHECK(fill() == 2.5);
        CHECK(screen.size().width == size.width);
        CHECK(screen.size().height == size.height);
        const Image image = screen.screenshot();
        REQUIRE(image.width == size.width);
        REQUIRE(image.height == size.height);
        const auto filled = std::count(image.pixels.begin(), image.pixels.end(), Rgb{9, 8, 7});
        CHECK(filled == std::int64_t{size.width} * size.height - 1);
        CHECK(image.at(0, 0) == Rgb{255, 255, 255});
    }
    CHECK(screen.complaints() == 0);
}

TEST_CASE("two screens do not disturb each other") {
    Offscreen one(small), two({100, 50});
    const auto fill = [](Offscreen& screen, ImU32 color) {
        screen.frame([color](const Input&) {
            ImGui::GetBackgroundDrawList()->AddRectFilled({0, 0}, ImGui::GetIO().DisplaySize, color);
            return 0.0;
        });
    };
    fill(one, IM_COL32(1, 1, 1, 255));
    fill(two, IM_COL32(2, 2, 2, 255));
    CHECK(one.screenshot().at(319, 199) == Rgb{1, 1, 1});
    CHECK(two.screenshot().at(99, 49) == Rgb{2, 2, 2});
}
