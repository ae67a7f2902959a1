#include "output/exr.hpp"

#include <fmt/core.h>
#include <tinyexr.h>

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>

#include "scene/error.hpp"

namespace glassbox {
namespace {

EXRChannelInfo info_of(const Channel& channel) {
    EXRChannelInfo info{};
    if (channel.name.size() >= sizeof info.name)
        throw Error(fmt::format("error: a channel's name in EXR has at most {} characters; {} has more",
                                sizeof info.name - 1, channel.name));
    std::copy(channel.name.begin(), channel.name.end(), info.name);
    return info;
}

std::vector<float> to_floats(const std::vector<double>& values) {
    std::vector<float> floats(values.size());
    std::transform(values.begin(), values.end(), floats.begin(), [](double v) { return static_cast<float>(v); });
    return floats;
}

/// Copies a text into a field of fixed size that ends with zeros.
template <std::size_t size>
void put(char (&field)[size], std::string_view text) {
    std::copy_n(text.data(), std::min(text.size(), size - 1), field);
}

/// The notes as attributes, which point to the notes' texts.
std::vector<EXRAttribute> attributes_of(std::vector<std::pair<std::string, std::string>>& notes) {
    std::vector<EXRAttribute> attributes;
    for (auto& [name, text] : notes) {
        EXRAttribute attribute{};
        put(attribute.name, name);
        attribute.name[0] = static_cast<char>(std::tolower(attribute.name[0]));  // as all names in EXR
        put(attribute.type, "string");
        attribute.value = reinterpret_cast<unsigned char*>(text.data());
        attribute.size = static_cast<int>(text.size());
        attributes.push_back(attribute);
    }
    return attributes;
}

}  // namespace

std::vector<std::byte> exr(std::span<const Measured> measured, const Origin& origin) {
    std::vector<const Channel*> channels = all_channels(measured);
    if (channels.empty() || channels.front()->width <= 0 || channels.front()->height <= 0)
        throw Error("error: an EXR picture has at least one channel and one pixel; this one has none");
    const int width = channels.front()->width;
    const int height = channels.front()->height;

    for (const Channel* channel : channels)
        if (channel->width != width || channel->height != height)
            throw std::invalid_argument("channels of different sizes do not fit in one EXR picture");
    // Sorted by name: readers rely on it.
    std::sort(channels.begin(), channels.end(), [](const Channel* a, const Channel* b) { return a->name < b->name; });

    std::vector<EXRChannelInfo> infos;
    std::vector<std::vector<float>> floats;
    for (const Channel* channel : channels) {
        infos.push_back(info_of(*channel));
        floats.push_back(to_floats(channel->values));
    }
    std::vector<unsigned char*> pixels;
    for (std::vector<float>& channel : floats) pixels.push_back(reinterpret_cast<unsigned char*>(channel.data()));
    std::vector<int> types(infos.size(), TINYEXR_PIXELTYPE_FLOAT);

    EXRHeader header;
    InitEXRHeader(&header);
    header.long_name = std::ranges::any_of(channels, [](const Channel* one) { return one->name.size() > 31; });
    header.num_channels = static_cast<int>(infos.size());
    header.channels = infos.data();
    header.pixel_types = types.data();
    header.requested_pixel_types = types.data();
    header.compression_type = TINYEXR_COMPRESSIONTYPE_ZIP;
    auto notes = notes_of(origin);
    std::vector<EXRAttribute> attributes = attributes_of(notes);
    header.num_custom_attributes = static_cast<int>(attributes.size());
    header.custom_attributes = attributes.data();

    EXRImage image;
    InitEXRImage(&image);
    image.images = pixels.data();
    image.width = width;
    image.height = height;
    image.num_channels = header.num_channels;

    unsigned char* memory = nullptr;
    const char* message = nullptr;
    const std::size_t size = SaveEXRImageToMemory(&image, &header, &memory, &message);
    const std::unique_ptr<unsigned char, decltype(&std::free)> owner(memory, &std::free);
    if (size == 0) {
        const std::string why = message ? message : "unknown reason";
        FreeEXRErrorMessage(message);
        throw Error(fmt::format("error: cannot encode EXR: {}; write .csv instead", why));
    }
    const auto bytes = std::as_bytes(std::span(memory, size));
    return {bytes.begin(), bytes.end()};
}

}  // namespace glassbox
