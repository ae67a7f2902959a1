#pragma once
#include <cstddef>
#include <filesystem>
#include <span>
#include <stop_token>
#include <string>
#include <vector>

#include "learn/picture/recording_update.hpp"
#include "render/options.hpp"
#include "render/pixel.hpp"
#include "scene/scene.hpp"

namespace glassbox::learn::mine {

/// What is to be recorded.
struct ToRecord {
    const Scene& scene;
    const Options& options;  ///< all but the scalar: it is recorded in double
    Pixel pixel;
    std::vector<std::size_t> listed;  ///< surfaces whose tests are wanted though they are missed, in order
};

/// A header of the learner's.
struct OwnHeader {
    std::filesystem::path path;  ///< absolute
    std::string text;
};

/// Records a pixel's steps with a learner's program, compiled for the options' rules, in a subprocess. If the program
/// crashes or does not end, the steps until then are returned, and how it ended. `root` is the folder that it was
/// compiled in. Throws Error if the system has no memory or process to give.
RecordingUpdate record(const std::filesystem::path& stepper, const ToRecord& what, const std::filesystem::path& root,
                       std::span<const OwnHeader> headers, const std::stop_token& stop = {});

}  // namespace glassbox::learn::mine
