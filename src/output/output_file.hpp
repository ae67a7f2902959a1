#pragma once
#include <filesystem>
#include <span>
#include <stop_token>
#include <string_view>

#include "output/measured.hpp"
#include "output/origin.hpp"
#include "render/image.hpp"

namespace glassbox {

// The name's extension, in either case, chooses the format. A device or pipe without one, such as /dev/stdout, gets PNG
// for pictures and CSV for measurements. All functions throw Error as write_whole does, and for an unknown extension.

/// Checks that a picture can be written there; call it before the work.
void check_picture_file(const std::filesystem::path& path);

/// Checks that measurements can be written there; call it before the work.
void check_measurements_file(const std::filesystem::path& path);

/// The format that the name chooses, as an extension in lower case: ".png".
std::string_view picture_extension(const std::filesystem::path& path);
std::string_view measurements_extension(const std::filesystem::path& path);

/// Writes .png or .ppm, with its origin. Throws Cancelled when asked to stop.
void write_picture(const std::filesystem::path& path, const Image& image, const Origin& origin,
                   std::stop_token stop = {});

/// Writes .png or .ppm: heat maps with legends; .csv or .exr: the numbers; with their origin, for which only .csv has
/// no place. Throws Cancelled when asked to stop.
void write_measurements(const std::filesystem::path& path, std::span<const Measured> measured, const Origin& origin,
                        std::stop_token stop = {});

}  // namespace glassbox
