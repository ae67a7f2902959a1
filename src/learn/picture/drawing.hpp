#pragma once
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "learn/picture/sheet.hpp"
#include "learn/subprocess/subprocess.hpp"
#include "render/image.hpp"
#include "render/options.hpp"
#include "scene/scene.hpp"

namespace glassbox::learn::mine {

/// A pixel, from the top left.
struct Spot {
    int x = 0, y = 0;

    bool operator==(const Spot&) const = default;
};

/// What a learner's renderer has drawn, perhaps only part of the picture. A pixel that is not drawn yet has the colour
/// of the pixel of a coarser picture that covers it, if there is one, or else is black.
struct Drawing {
    Image image;
    std::vector<SheetPixel::State> states;  ///< what became of each pixel, as `image` has them
    std::int64_t drawn = 0;
    std::int64_t not_numbers = 0;            ///< of those drawn: made of something that is not a number
    std::optional<Spot> first_not_a_number;  ///< from the top left
    std::int64_t undecided = 0;              ///< of those drawn: bounds left open what is seen there
    std::optional<Spot> first_undecided;     ///< from the top left
};

/// How the drawing ended.
struct Drawn {
    std::shared_ptr<const Drawing> drawing;
    Outcome outcome;
    Stage at = Stage::starting;  ///< how far it came
    std::optional<Spot> spot;    ///< the pixel that it was at when it ended before it was done
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
