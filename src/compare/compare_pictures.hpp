#pragma once
#include <optional>
#include <string>
#include <vector>

#include "compare/compare_rays.hpp"
#include "render/image.hpp"
#include "render/pixel.hpp"

namespace glassbox {

/// What a pixel of another colour comes from.
enum class Seen {
    color,       ///< the true surface; its colour is rounded, or cut to a byte, in another way
    neighbour,   ///< another surface, or none, for which rounding decides
    tie,         ///< another surface at exactly the same t
    behind,      ///< the colour of what lies behind the true surface
    background,  ///< the background, where a surface is surely met
    shading,     ///< none of these: another shading
    nothing,     ///< a colour where nothing is met
    border,      ///< the border, which the scene paints over the picture
};
inline constexpr std::size_t seen_count = 8;

/// One pixel that differs.
struct PixelDifference {
    Pixel pixel;
    Rgb theirs, ours;
    int off = 0;  ///< the greatest difference of a channel
    Seen seen = Seen::shading;
    Cause cause = Cause::mistake;
    std::optional<Hit<double>> truth;  ///< what is truly seen there; none: the background
    std::optional<std::size_t>
        surface;  ///< of neighbour and behind: the one that has their colour; none: the background
    std::vector<CloseCall> calls;
};

/// Something that was tried and found to explain nearly all: their picture is another one of ours.
struct Explanation {
    std::string words;             ///< "flipped top to bottom"
    std::size_t still_differ = 0;  ///< pixels that differ then
    std::size_t compared = 0;      ///< of so many
};

/// Two pictures of one size.
struct PictureComparison {
    Image ours;
    std::size_t differ = 0;
    int greatest = 0;                          ///< difference of a channel
    double mean = 0;                           ///< of the greatest difference of a channel, over those that differ
    std::vector<PixelDifference> looked_into;  ///< all that differ; or, if they are very many, some that lie evenly
    std::vector<Explanation> explanations;     ///< the best first

    std::size_t count(Cause cause) const;
    std::size_t count(Seen seen, Cause cause) const;
    bool is_all() const { return looked_into.size() == differ; }
};

/// Compares their picture of the scene with ours, which has to be of that size. The options' scalar must be a proven
/// one. Throws Cancelled.
PictureComparison compare_pictures(const Scene& scene, bool is_resized, const Options& options, const Image& picture,
                                   const Theirs& theirs, const Job& job);

/// What their picture would be of ours, if hardly a pixel differs then: flipped, shifted by a pixel or half of one, red
/// and blue swapped, with another gamma. Only what was tried is told.
std::vector<Explanation> explanations(const Scene& scene, const Options& options, const Image& theirs,
                                      const Image& ours, std::size_t differ, const Job& job);

}  // namespace glassbox
