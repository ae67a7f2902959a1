#include <doctest.h>

#include <string>

#include "output/folder.hpp"
#include "output/output_file.hpp"
#include "output/png.hpp"
#include "output/ppm.hpp"
#include "render/job.hpp"
#include "scene/error.hpp"

#define STBI_ONLY_PNG
#define STB_IMAGE_STATIC
#define STB_IMAGE_IMPLEMENTATION
#include <stb_image.h>

using namespace glassbox;
using namespace glassbox::test;

namespace {

/// Every channel of every pixel differs from its neighbours'.
Image motley(int width, int height) {
    Image image(width, height);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            image.at(x, y) = {static_cast<std::uint8_t>(7 * x + 31 * y), static_cast<std::uint8_t>(255 - x),
                              static_cast<std::uint8_t>(x * y)};
    return image;
}

Image read_png(const std::vector<std::byte>& bytes) {
    int width = 0, height = 0, channels = 0;
    unsigned char* data = stbi_load_from_memory(reinterpret_cast<const unsigned char*>(bytes.data()),
                                                static_cast<int>(bytes.size()), &width, &height, &channels, 0);
    REQUIRE(data != nullptr);
    REQUIRE(channels == 3);
    Image image(width, height);
    for (std::size_t i = 0; i < image.pixels.size(); ++i)
        image.pixels[i] = {data[3 * i], data[3 * i + 1], data[3 * i + 2]};
    stbi_image_free(data);
    return image;
}

struct Chunk {
    std::string type, data;
};

/// By PNG's specification, annex D: the remainder of a division of polynomials, a bit at a time.
std::uint32_t checksum(const std::string& bytes) {
    std::uint32_t remainder = 0xffffffff;
    for (const char byte : bytes) {
        remainder ^= static_cast<unsigned char>(byte);
        for (int bit = 0; bit < 8; ++bit) remainder = remainder >> 1 ^ (remainder & 1 ? 0xedb88320 : 0);
    }
    return ~remainder;
}

/// A PNG's chunks; their checksums must be right.
std::vector<Chunk> chunks_of(const std::vector<std::byte>& png) {
    const std::string file(reinterpret_cast<const char*>(png.data()), png.size());
    const auto number = [&](std::size_t at) {
        std::uint32_t value = 0;
        for (std::size_t i = at; i < at + 4; ++i) value = value << 8 | static_cast<unsigned char>(file.at(i));
        return value;
    };
    std::vector<Chunk> chunks;
    for (std::size_t at = 8; at < file.size();) {
        const std::size_t size = number(at);
        chunks.push_back({file.substr(at + 4, 4), file.substr(at + 8, size)});
        CHECK(number(at + 8 + size) == checksum(chunks.back().type + chunks.back().data));
        at += 12 + size;
    }
    return chunks;
}

}  // namespace

TEST_CASE("a PNG reads back as the same picture") {
    for (const auto& [width, height] : {std::pair{1, 1}, {500, 3}, {1, 700}, {97, 101}}) {
        const Image image = motley(width, height);
        const Image back = read_png(png(image));
        CHECK(back.width == width);
        CHECK(back.height == height);
        CHECK(back.pixels == image.pixels);
    }
}

TEST_CASE("the same picture makes the same PNG") { CHECK(png(motley(50, 50)) == png(motley(50, 50))); }

TEST_CASE("a PNG's origin: chunks of text before its pixels, each with the checksum that PNG asks for") {
    const Image image = motley(5, 4);
    const std::vector<std::byte> file = png(image, {"glassbox render room"});
    CHECK(read_png(file).pixels == image.pixels);
    const std::vector<Chunk> chunks = chunks_of(file);
    REQUIRE(chunks.size() == 5);
    CHECK(chunks[0].type == "IHDR");
    CHECK(chunks[1].type == "tEXt");
    CHECK(chunks[1].data.starts_with(std::string("Software\0Glassbox ", 18)));
    CHECK(chunks[2].type == "tEXt");
    CHECK(chunks[2].data == std::string("Command\0glassbox render room", 28));
    CHECK(chunks[3].type == "IDAT");
    // What is not ASCII is UTF-8, in iTXt: not compressed, by no method, in no language, its keyword not translated.
    const std::vector<Chunk> german = chunks_of(png(image, {"glassbox render schön"}));
    CHECK(german[2].type == "iTXt");
    CHECK(german[2].data == std::string("Command\0\0\0\0\0glassbox render schön", 34));
    CHECK(chunks_of(png(image)).size() == 3);  // no command, no text
}

TEST_CASE("pictures that PNG cannot hold are refused") {
    CHECK_THROWS_AS(png(Image(0, 5)), Error);
    Image wide(0, 0);  // no pixels are needed to see that these would be too many
    wide.width = wide.height = 40000;
    CHECK(message_of<Error>([&] { png(wide); }).find("write .ppm") != std::string::npos);
}

TEST_CASE("a PPM is a header and the bytes") {
    Image image(2, 1);
    image.at(0, 0) = {'a', 'b', 'c'};
    image.at(1, 0) = {'d', 'e', 'f'};
    const std::vector<std::byte> file = ppm(image);
    CHECK(std::string(reinterpret_cast<const char*>(file.data()), file.size()) == "P6\n2 1\n255\nabcdef");
    const std::vector<std::byte> made = ppm(image, {"glassbox render room"});
    const std::string text(reinterpret_cast<const char*>(made.data()), made.size());
    CHECK(text.starts_with("P6\n# Software: Glassbox "));
    CHECK(text.find("\n# Command: glassbox render room\n2 1\n255\nabcdef") != std::string::npos);
}

TEST_CASE("the extension chooses the format, in either case") {
    const Folder folder;
    const Image image = motley(5, 4);
    write_picture(folder / "a.png", image, {});
    write_picture(folder / "A.PNG", image, {});
    write_picture(folder / "a.ppm", image, {});
    CHECK(content(folder / "a.png").substr(0, 4) == "\x89PNG");
    CHECK(content(folder / "A.PNG") == content(folder / "a.png"));
    CHECK(content(folder / "a.ppm").substr(0, 2) == "P6");
    write_picture("/dev/null", image, {});  // a device needs none
}

TEST_CASE("an unknown extension names the known ones, and nothing is written") {
    const Folder folder;
    CHECK(message_of<Error>([&] { write_picture(folder / "a.gif", motley(2, 2), {}); }) ==
          (folder / "a.gif").string() + ": error: unknown extension .gif; use .png or .ppm");
    CHECK(message_of<Error>([&] { check_picture_file(folder / "picture"); }) ==
          (folder / "picture").string() + ": error: the name has no extension; use .png or .ppm");
    CHECK(message_of<Error>([&] { check_measurements_file(folder / "a.txt"); }) ==
          (folder / "a.txt").string() + ": error: unknown extension .txt; use .csv, .png, .ppm or .exr");
    CHECK(folder.entries() == 0);
}

TEST_CASE("a stopped picture is not written") {
    const Folder folder;
    std::stop_source source;
    source.request_stop();
    CHECK_THROWS_AS(write_picture(folder / "a.png", motley(2, 2), {}, source.get_token()), Cancelled);
    CHECK(folder.entries() == 0);
}

TEST_CASE("measurements are written in every format") {
    const Folder folder;
    static constexpr std::string_view names[] = {"depth"};
    const Measurement what{"depth", "|D|", "t of the nearest surface", Scale::sequential, Source::hit, {}, names, {}};
    const Channel plane{"depth", 2, 1, {1.5, no_value}};
    const Measured measured{&what, {&plane, 1}};
    for (const std::string name : {"m.csv", "m.png", "m.ppm", "m.exr"})
        write_measurements(folder / name, {&measured, 1}, {});
    CHECK(content(folder / "m.csv") == "x,y,depth\n0,0,1.5\n1,0,\n");
    CHECK(content(folder / "m.png").substr(0, 4) == "\x89PNG");
    CHECK(content(folder / "m.exr").substr(0, 4) == "\x76\x2f\x31\x01");  // OpenEXR's magic number
    CHECK(folder.entries() == 4);
}
