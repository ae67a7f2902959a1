#include "output/exr.hpp"

#include <doctest.h>
#include <tinyexr.h>

#include <cmath>
#include <limits>
#include <map>
#include <stdexcept>
#include <string>

#include "scene/error.hpp"

using namespace glassbox;

namespace {

std::vector<std::byte> exr_of(std::span<const Channel> channels) {
    static const Measurement any{"any", "", "", Scale::sequential, Source::hit, {}, {}, {}};
    const Measured measured{&any, channels};
    return exr({&measured, 1});
}

struct Loaded {
    std::map<std::string, std::string> texts;  // attributes of type string
    int width = 0, height = 0;
    std::vector<std::string> names;                    // in the file's order
    std::map<std::string, std::vector<float>> values;  // by name
};

Loaded load(const std::vector<std::byte>& file) {
    const auto* memory = reinterpret_cast<const unsigned char*>(file.data());
    EXRVersion version;
    EXRHeader header;
    EXRImage image;
    InitEXRHeader(&header);
    InitEXRImage(&image);
    const char* error = nullptr;
    REQUIRE(ParseEXRVersionFromMemory(&version, memory, file.size()) == TINYEXR_SUCCESS);
    REQUIRE(ParseEXRHeaderFromMemory(&header, &version, memory, file.size(), &error) == TINYEXR_SUCCESS);
    REQUIRE(LoadEXRImageFromMemory(&image, &header, memory, file.size(), &error) == TINYEXR_SUCCESS);

    Loaded loaded{{}, image.width, image.height, {}, {}};
    for (int i = 0; i < header.num_custom_attributes; ++i) {
        const EXRAttribute& attribute = header.custom_attributes[i];
        if (std::string(attribute.type) == "string")
            loaded.texts[attribute.name].assign(reinterpret_cast<const char*>(attribute.value),
                                                static_cast<std::size_t>(attribute.size));
    }
    for (int i = 0; i < header.num_channels; ++i) {
        REQUIRE(header.pixel_types[i] == TINYEXR_PIXELTYPE_FLOAT);
        const auto* first = reinterpret_cast<const float*>(image.images[i]);
        loaded.names.emplace_back(header.channels[i].name);
        loaded.values[header.channels[i].name] = {first, first + image.width * image.height};
    }
    FreeEXRImage(&image);
    FreeEXRHeader(&header);
    return loaded;
}

}  // namespace

TEST_CASE("channels have the channels' names, in order of name, and their values as floats") {
    const float infinity = std::numeric_limits<float>::infinity();
    const Channel channels[] = {{"normal.z", 3, 2, {0, 0.25, 0.5, 0.75, 1, -1}},
                                {"depth", 3, 2, {0.1, 1e300, -1e300, 16777217, no_value, 1e-300}},
                                {"n.l", 3, 2, {1, 2, 3, 4, 5, 6}}};
    const Loaded loaded = load(exr_of(channels));
    CHECK(loaded.width == 3);
    CHECK(loaded.height == 2);
    CHECK(loaded.names == std::vector<std::string>{"depth", "n.l", "normal.z"});
    CHECK(loaded.values.at("normal.z") == std::vector<float>{0, 0.25, 0.5, 0.75, 1, -1});
    CHECK(loaded.values.at("n.l") == std::vector<float>{1, 2, 3, 4, 5, 6});
    const std::vector<float>& depth = loaded.values.at("depth");
    CHECK(depth[0] == 0.1f);
    CHECK(depth[1] == infinity);
    CHECK(depth[2] == -infinity);
    CHECK(depth[3] == 16777216);  // 2^24 + 1 is half way to 2^24 + 2: to even
    CHECK(std::isnan(depth[4]));
    CHECK(depth[5] == 0);
}

TEST_CASE("sizes from one pixel to many blocks of lines") {
    for (const auto& [width, height] : {std::pair{1, 1}, {1, 50}, {333, 1}, {200, 100}}) {
        Channel plane{"v", width, height, {}};
        std::vector<float> expected;
        for (int i = 0; i < width * height; ++i) {
            plane.values.push_back(std::sin(i));
            expected.push_back(static_cast<float>(std::sin(i)));
        }
        CHECK(load(exr_of({&plane, 1})).values.at("v") == expected);
    }
}

TEST_CASE("an EXR's origin: attributes") {
    static const Measurement any{"any", "", "", Scale::sequential, Source::hit, {}, {}, {}};
    const Channel plane{"v", 1, 1, {0.5}};
    const Measured measured{&any, {&plane, 1}};
    const Loaded loaded = load(exr({&measured, 1}, {"glassbox measure schön --what any"}));
    CHECK(loaded.texts.at("command") == "glassbox measure schön --what any");
    CHECK(loaded.texts.at("software").starts_with("Glassbox "));
    CHECK(loaded.values.at("v") == std::vector<float>{0.5});
    CHECK(load(exr({&measured, 1})).texts.empty());
}

TEST_CASE("what EXR cannot hold is refused") {
    CHECK_THROWS_AS(exr_of({}), Error);
    const Channel long_name{std::string(300, 'n'), 1, 1, {1}};
    CHECK_THROWS_AS(exr_of({&long_name, 1}), Error);
    const Channel sizes[] = {{"a", 2, 1, {1, 2}}, {"b", 1, 2, {1, 2}}};
    CHECK_THROWS_AS(exr_of(sizes), std::invalid_argument);
}
