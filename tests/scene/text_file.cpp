#include "scene/text_file.hpp"

#include "scene/files.hpp"

using namespace glassbox;
using glassbox::test::complaint;
using glassbox::test::Folder;

TEST_CASE("A text file is read to the byte") {
    const Folder folder;
    const std::string text = "one\r\ntwo\n" + std::string(200000, 'x');
    CHECK(read_text(folder.write("a.txt", text)) == text);
    CHECK(read_text(folder.write("b.txt", "")).empty());
}

TEST_CASE("Lines end as on Unix, on Windows and on old Macs, and no byte order mark is left") {
    const Folder folder;
    const auto lines = [&](std::string_view text) { return read_lines(folder.write("a.txt", text)); };
    CHECK(lines("one\ntwo\r\nthree\n") == "one\ntwo\r\nthree\n");
    CHECK(lines("one\rtwo\r\rfour\r") == "one\ntwo\n\nfour\n");
    CHECK(lines("one\r\r\ntwo\r") == "one\r\r\ntwo\n");  // a line end that Windows has converted twice
    CHECK(lines("\xEF\xBB\xBFone") == "one");
    CHECK(lines("\r") == "\n");
    CHECK(lines("").empty());
}

TEST_CASE("A byte 0 is found, however late") {
    const Folder folder;
    const auto file = folder.write("a.txt", std::string(300000, 'x') + '\0');
    CHECK(complaint(folder, [&] { read_text(file); }) == "a.txt: error: this is a binary file; it must be a text file");
}

TEST_CASE("UTF-8 is what RFC 3629 says it is") {
    for (const auto* good : {"", "a", "ü", "€", "日本", "🙂", "\xF4\x8F\xBF\xBF", "\xED\x9F\xBF"})
        CHECK_FALSE(first_not_utf8(good));
    CHECK(first_not_utf8("ab\xFFz") == 2);           // never a lead
    CHECK(first_not_utf8("\x80") == 0);              // a continuation without a lead
    CHECK(first_not_utf8("ü\xC3") == 2);             // cut short
    CHECK(first_not_utf8("\xC0\x80") == 0);          // 0 in two bytes
    CHECK(first_not_utf8("\xE0\x80\x80") == 0);      // 0 in three
    CHECK(first_not_utf8("\xF0\x80\x80\x80") == 0);  // 0 in four
    CHECK(first_not_utf8("\xED\xA0\x80") == 0);      // a surrogate
    CHECK(first_not_utf8("\xF4\x90\x80\x80") == 0);  // beyond U+10FFFF
}

TEST_CASE("Quoted text fits in a line of a message") {
    CHECK(in_quotes("radius") == "'radius'");
    CHECK(in_quotes("a\nb\x1b[31m") == "'a?b?[31m'");
    CHECK(in_quotes(std::string(61, 'x')) == "'" + std::string(60, 'x') + "…'");
    CHECK(in_quotes(std::string(59, 'x') + "ü") == "'" + std::string(59, 'x') + "…'");
}
