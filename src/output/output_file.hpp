#pragma once
#include <filesystem>
#include <span>
#include <stop_token>

#include "output/measured.hpp"
#include "render/image.hpp"

namespace glassbox {

// The name's extension, in either case, chooses the format. A device or pipe without one, such as /dev/stdout, gets PNG
// for pictures and CSV for measurements. All functions throw Error as write_whole does, and for an unknown extension.

/// Checks that a picture can be written there; call it before the work.
void check_picture_file(const std::filesystem::path& path);

/// Checks that measurements can be written there; call it before the work.
void check_measurements_file(const std::filesystem::path& path);

/// Writes .png or .ppm. Throws Cancelled when asked to stop.
void write_picture(const std::filesystem::path& path, const Image& image, std::stop_token stop = {});

/// Writes .png or .ppm: heat maps with legends; .csv or .exr: the numbers. Throws Cancelled when asked to stop.
void write_measurements(const std::filesystem::path& path, std::span<const Measured> measured,
                        std::stop_token stop = {});

}  // namespace glassbox
