#include "output/exr.hpp"

#include <fmt/core.h>
#include <tinyexr.h>

#include <algorithm>
#include <cstdlib>
#include <memory>
#include <stdexcept>
#include <string>

#include "scene/error.hpp"

namespace glassbox {
namespace {

EXRChannelInfo channel_of(const Plane& plane) {
    EXRChannelInfo channel{};
    if (plane.name.size() >= sizeof channel.name)
        throw Error(fmt::format("error: a channel's name in EXR has at most {} characters; {} has more",
                                sizeof channel.name - 1, plane.name));
    std::copy(plane.name.begin(), plane.name.end(), channel.name);
    return channel;
}

std::vector<float> to_floats(const std::vector<double>& values) {
    std::vector<float> floats(values.size());
    std::transform(values.begin(), values.end(), floats.begin(), [](double v) { return static_cast<float>(v); });
    return floats;
}

}  // namespace

std::vector<std::byte> exr(std::span<const Measured> measured) {
    std::vector<const Plane*> planes = all_planes(measured);
    if (planes.empty() || planes.front()->width <= 0 || planes.front()->height <= 0)
        throw Error("error: an EXR picture has at least one channel and one pixel; this one has none");
    const int width = planes.front()->width;
    const int height = planes.front()->height;

    for (const Plane* plane : planes)
        if (plane->width != width || plane->height != height)
            throw std::invalid_argument("planes of different sizes do not fit in one EXR picture");
    // By name: readers rely on it.
    std::sort(planes.begin(), planes.end(), [](const Plane* a, const Plane* b) { return a->name < b->name; });

    std::vector<EXRChannelInfo> channels;
    std::vector<std::vector<float>> floats;
    for (const Plane* plane : planes) {
        channels.push_back(channel_of(*plane));
        floats.push_back(to_floats(plane->values));
    }
    std::vector<unsigned char*> pixels;
    for (std::vector<float>& channel : floats) pixels.push_back(reinterpret_cast<unsigned char*>(channel.data()));
    std::vector<int> types(channels.size(), TINYEXR_PIXELTYPE_FLOAT);

    EXRHeader header;
    InitEXRHeader(&header);
    header.num_channels = static_cast<int>(channels.size());
    header.channels = channels.data();
    header.pixel_types = types.data();
    header.requested_pixel_types = types.data();
    header.compression_type = TINYEXR_COMPRESSIONTYPE_ZIP;

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
