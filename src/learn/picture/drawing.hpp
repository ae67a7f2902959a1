#pragma once
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>

#include "learn/picture/picture_update.hpp"
#include "learn/picture/sheet.hpp"
#include "learn/subprocess/subprocess.hpp"
#include "render/options.hpp"
#include "scene/scene.hpp"

namespace glassbox::learn::mine {

/// How the drawing ended.
struct Drawn {
    std::shared_ptr<const Drawing> drawing;
    Outcome outcome;
    Stage at = Stage::starting;  ///< how far it came
    std::optional<Pixel> spot;   ///< the pixel that it was at when it ended before it was done
    bool not_written = false;    ///< it ended because a function is not written yet: the last words say which
};

/// Draws a scene in double with a learner's renderer, compiled for the options' rules, in a subprocess. Calls `show`
/// with what is there, from time to time. Uses all options but the scalar. Throws Error if the system has no memory or
/// process to give.
Drawn draw(const std::filesystem::path& renderer, const Scene& scene, const Options& options,
           const std::function<void(std::shared_ptr<const Drawing>)>& show, const std::stop_token& stop = {});

/// Returns what went wrong, in words, and at which pixel; empty if all of the picture is drawn.
std::string what_became_of(const Drawn& drawn);

}  // namespace glassbox::learn::mine
