#include "output/output_file.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include "output/exr.hpp"
#include "output/heat_map.hpp"
#include "output/png.hpp"
#include "output/ppm.hpp"
#include "output/table.hpp"
#include "output/whole_file.hpp"
#include "scene/error.hpp"
#include "scene/suggestion.hpp"

namespace glassbox {
namespace {

namespace fs = std::filesystem;
using Extensions = std::span<const std::string_view>;

constexpr std::string_view picture_files[] = {".png", ".ppm"};
constexpr std::string_view measurement_files[] = {".csv", ".png", ".ppm", ".exr"};

/// The path's extension, one of `known`; the first of them for a device without an extension.
std::string_view extension_of(const fs::path& path, Extensions known) {
    std::string extension = path.extension().string();
    if (extension.empty() && is_device(path)) return known.front();
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
    const auto found = std::find(known.begin(), known.end(), extension);
    if (found != known.end()) return *found;
    const std::string what =
        extension.empty() ? "the name has no extension" : "unknown extension " + path.extension().string();
    throw error_at({path.string()}, fmt::format("{}; use {}", what, either({known.begin(), known.end()})));
}

std::vector<std::byte> encoded(const Image& image, std::string_view extension, const Origin& origin) {
    return extension == ".ppm" ? ppm(image, origin) : png(image, origin);
}

}  // namespace

std::string_view picture_extension(const fs::path& path) { return extension_of(path, picture_files); }

std::string_view measurements_extension(const fs::path& path) { return extension_of(path, measurement_files); }

void check_picture_file(const fs::path& path) {
    check_writable(path);
    picture_extension(path);
}

void check_measurements_file(const fs::path& path) {
    check_writable(path);
    measurements_extension(path);
}

void write_picture(const fs::path& path, const Image& image, const Origin& origin, std::stop_token stop) {
    check_picture_file(path);
    write_whole(path, encoded(image, picture_extension(path), origin), stop);
}

void write_measurements(const fs::path& path, std::span<const Measured> measured, const Origin& origin,
                        std::stop_token stop) {
    check_measurements_file(path);
    const std::string_view extension = measurements_extension(path);
    if (extension == ".csv")
        write_whole(
            path, [&](const Sink& sink) { table(measured, sink); }, stop);
    else if (extension == ".exr") write_whole(path, exr(measured, origin), stop);
    else write_whole(path, encoded(heat_map(measured), extension, origin), stop);
}

}  // namespace glassbox
