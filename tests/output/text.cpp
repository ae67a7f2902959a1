#include "output/text.hpp"

#include <doctest.h>

#include <algorithm>

using namespace glassbox;

namespace {

constexpr Rgb paper{255, 255, 255};

Image drawn(std::string_view text) {
    Image image(400, 40, paper);
    draw_text(image, 5, 5, text, {30, {0, 0, 0}});
    return image;
}

/// Left and right end of what was drawn; right is -1 if nothing was.
std::pair<int, int> inked_columns(const Image& image) {
    std::pair<int, int> ends{image.width, -1};
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x)
            if (image.at(x, y) != paper) ends = {std::min(ends.first, x), std::max(ends.second, x)};
    return ends;
}

}  // namespace

TEST_CASE("text is drawn inside its width, and smoothed") {
    const Image image = drawn("n·l ≥ 0.5");
    const auto [left, right] = inked_columns(image);
    CHECK(left >= 5);
    CHECK(right <= 5 + text_width("n·l ≥ 0.5", 30));
    CHECK(right > 5 + text_width("n·l ≥ 0.5", 30) - 6);
    CHECK(std::any_of(image.pixels.begin(), image.pixels.end(), [](Rgb p) { return p.red > 0 && p.red < 255; }));
    CHECK(std::find(image.pixels.begin(), image.pixels.end(), Rgb{0, 0, 0}) != image.pixels.end());
}

TEST_CASE("the font has the signs that our formulas need") {
    // A character that the font lacks is drawn as the box shown for U+10FFFF, which no font has.
    const Image missing = drawn("\U0010FFFF");
    CHECK(inked_columns(missing).second > 0);
    for (const char* sign : {"·", "×", "²", "√", "≥", "ε", "−", "°", "∞", "⁰", "⁹", "⁻", "ᵉ", "|"}) {
        CAPTURE(sign);
        CHECK(drawn(sign).pixels != missing.pixels);
        CHECK(inked_columns(drawn(sign)).second > 0);
    }
}

TEST_CASE("bytes that are not UTF-8 are shown as unknown characters") {
    for (const char* bad : {"\xff", "\x80", "\xc3", "\xe2\x88"}) CHECK(inked_columns(drawn(bad)).second > 0);
    CHECK(drawn("\xff").pixels == drawn("\uFFFD").pixels);
}

TEST_CASE("what lies outside the picture is cut") {
    Image image(20, 10, paper);
    for (const int place : {-1000, -10, 0, 15, 1000}) draw_text(image, place, place, "cut", {30, {0, 0, 0}});
    Image none(0, 0);
    draw_text(none, 0, 0, "cut", {30, {0, 0, 0}});
}

TEST_CASE("a wider text is wider") {
    CHECK(text_width("", 20) == 0);
    CHECK(text_width("ii", 20) > text_width("i", 20));
    CHECK(text_width("i", 40) > text_width("i", 20));
}

TEST_CASE("lines are broken between words, long words between characters") {
    const std::string text = "the cosine of the angle between normal and light";
    const std::vector<std::string> lines = wrapped(text, 20, 150);
    std::string joined;
    for (const std::string& line : lines) {
        CHECK(text_width(line, 20) <= 150);
        joined += (joined.empty() ? "" : " ") + line;
    }
    CHECK(lines.size() > 2);
    CHECK(joined == text);

    joined.clear();
    for (const std::string& line : wrapped("²²²²²²²²²²²²²²²²²²²²", 20, 50)) {
        CHECK(text_width(line, 20) <= 50);
        joined += line;
    }
    CHECK(joined == "²²²²²²²²²²²²²²²²²²²²");
    CHECK(wrapped("abc", 20, 1) == std::vector<std::string>{"a", "b", "c"});
    CHECK(wrapped("  a  b ", 20, 100) == std::vector<std::string>{"a b"});
    CHECK(wrapped("", 20, 100).empty());
}
