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

/// How the drawing came to its end.
struct Drawn {
    std::shared_ptr<const Drawing> drawing;
    Outcome outcome;
    Stage at = Stage::starting;  ///< how far it came
    std::optional<Pixel> spot;   ///< the pixel that it was at when it ended before it was done
    bool not_written = false;    ///< it ended because a function is not written yet: the last words say which
};

/// Lets a learner's renderer, which was compiled for the options' rules, draw a scene, in double, in a process of its
/// own. `show` is given what is there, from time to time. Of the options all but the scalar count. Throws Error if the
/// system has no memory or process to give.
Drawn draw(const std::filesystem::path& renderer, const Scene& scene, const Options& options,
           const std::function<void(std::shared_ptr<const Drawing>)>& show, const std::stop_token& stop = {});

/// What went wrong, in words, at which pixel; empty if all of the picture is drawn.
std::string what_became_of(const Drawn& drawn);

}  // namespace glassbox::learn::mine
