#include "scene/printable.hpp"

#include <doctest.h>

using namespace glassbox;

TEST_CASE("What can be shown is left as it is") {
    for (const char* text :
         {"", "radius", "½ ± 3.1e-10", "Röhre, трубка, 管, أنبوب, צינור", "🙂", "\xEF\xBF\xBD", "~ "})
        CHECK(printable(text) == text);
}

TEST_CASE("One '?' for each character that a terminal obeys") {
    for (unsigned c = 0; c < 0x20; ++c) CHECK(printable(std::string(1, static_cast<char>(c))) == "?");  // C0
    CHECK(printable("a\x7Fz") == "a?z");                                                                // delete
    // C1, U+0080 to U+009F, is C2 80 to C2 9F in UTF-8; U+00A0 after it is a blank that can be shown.
    for (unsigned c = 0x80; c < 0xA0; ++c) CHECK(printable(std::string("\xC2") + static_cast<char>(c)) == "?");
    CHECK(printable("\u00A0") == "\u00A0");
    CHECK(printable("\x1B]0;title\x07\x1B[31mred") == "?]0;title??[31mred");
    CHECK(printable("\u2028\u2029") == "??");
}

TEST_CASE("One '?' for each character that turns the direction of writing") {
    // Unicode's property Bidi_Control (PropList.txt): 061C, 200E..200F, 202A..202E, 2066..2069.
    CHECK(printable("\u061C\u200E\u200F\u202A\u202B\u202C\u202D\u202E\u2066\u2067\u2068\u2069") ==
          std::string(12, '?'));
    CHECK(printable("\u061B\u200D\u2010\u2027\u202F\u2065\u206A") == "\u061B\u200D\u2010\u2027\u202F\u2065\u206A");
}

TEST_CASE("One '?' for each byte that is not UTF-8") {
    CHECK(printable("\xE9t\xE9") == "?t?");               // Latin-1
    CHECK(printable("a\x9Bmz") == "a?mz");                // C1 in one byte, which some terminals obey
    CHECK(printable("ü\xC3") == "ü?");                    // cut short
    CHECK(printable("\xC0\x9B\xED\xA0\x80") == "?????");  // longer than need be; a surrogate
}

TEST_CASE("Lines keep their ends and tabs, and nothing else") {
    CHECK(printable_lines("a\tb\nc\rd\x1B[2J\n") == "a\tb\nc?d?[2J\n");
    CHECK(printable("a\tb\n") == "a?b?");
}
