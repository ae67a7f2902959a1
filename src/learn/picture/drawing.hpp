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

/// What a learner's renderer has drawn, perhaps not all of the picture. A pixel that it did not get to has the colour
/// of the one of a coarser picture that it belongs to, if that is there, or else is black.
struct Drawing {
    Image image;
    std::vector<SheetPixel::State> states;  ///< what became of each pixel, as `image` has them
    std::int64_t drawn = 0;
    std::int64_t not_numbers = 0;            ///< of those drawn: made of something that is not a number
    std::optional<Spot> first_not_a_number;  ///< from the top left
    std::int64_t undecided = 0;              ///< of those drawn: bounds left open what is seen there
    std::optional<Spot> first_undecided;     ///< from the top left
};

/// How the drawing came to its end.
struct Drawn {
    std::shared_ptr<const Drawing> drawing;
    Outcome outcome;
    Stage at = Stage::starting;  ///< how far it came
    std::optional<Spot> spot;    ///< the pixel that it was at when it ended before it was done
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
