#pragma once
#include <filesystem>
#include <stop_token>
#include <string>
#include <vector>

#include "learn/build/first_error.hpp"
#include "learn/build/toolchain.hpp"
#include "render/image.hpp"

namespace glassbox::learn {

/// The picture of a lesson's program, or why there is none.
struct LessonPicture {
    std::optional<CompileError> error;  ///< it did not compile
    std::string died;                   ///< how it ended early, in words; "" if it did not
    std::optional<Image> image;
    std::vector<std::string> said;  ///< the lines that it wrote to its standard error: which functions it still lacks
};

/// Compiles a lesson's main.cpp with the headers in a folder, and ours for those that are missing; runs it in a
/// subprocess; reads the picture that it wrote. The program is made in `folder`, which must exist. Throws Error if the
/// machine or the project is not as it should be.
LessonPicture lesson_picture(const Workspace& workspace, const Exercise& exercise, const Toolchain& tools,
                             const std::filesystem::path& headers, const std::filesystem::path& folder,
                             const std::stop_token& stop = {});

/// Reads a PPM file of the binary form, P6, with bytes from 0 to 255. Throws Error for anything else.
Image read_ppm(const std::filesystem::path& file);

}  // namespace glassbox::learn
