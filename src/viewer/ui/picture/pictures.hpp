#pragma once
#include <cstdint>
#include <optional>
#include <vector>

#include "viewer/model/overlay/difference.hpp"
#include "viewer/model/overlay/histogram.hpp"
#include "viewer/model/overlay/surfaces_in_picture.hpp"
#include "viewer/model/state/state.hpp"
#include "viewer/model/work/results.hpp"
#include "viewer/platform/texture.hpp"

namespace glassbox {

/// A picture's pixels as a texture takes them.
std::vector<Rgba> opaque(const Image& image);

/// The computed pictures as textures, and what is said of them; updated when there is something newer.
class Pictures {
public:
    void update(const ViewerState& state, const Results& results);

    const Texture& picture() const { return picture_; }
    const Texture& overlay() const { return overlay_; }        ///< a measurement's colours
    const Texture& other() const { return other_; }            ///< another scalar's or rule's picture
    const Texture& difference() const { return difference_; }  ///< between the two

    /// What the overlay's colours stand for, one for each plane; empty while nothing is measured.
    const std::vector<Distribution>& distributions() const { return distributions_; }

    /// Around the pixels that show the surface that is lit up; empty where none does.
    const std::vector<PixelBorder>& lit_outline() const { return lit_outline_; }

    /// How many pixels of the overlay are brushed.
    std::int64_t brushed() const { return brushed_; }

    /// How much the final pictures differ; none until both are there.
    struct Differing {
        std::int64_t pixels;
        int greatest;
        Pixel where;
    };
    const std::optional<Differing>& differing() const { return differing_; }

private:
    Texture picture_, overlay_, other_, difference_;
    std::uint64_t picture_serial_ = 0, overlay_serial_ = 0, other_serial_ = 0, difference_serial_ = 0;
    std::vector<Distribution> distributions_;
    std::optional<Differing> differing_;

    /// By what an overlay's colours were chosen, and how they were drawn.
    struct Look {
        SetRange range;
        SetSpacing spacing;
        bool operator==(const Look&) const = default;
    };
    struct Marks {
        std::optional<Brush> brush;
        int side = 1;  ///< of a pixel that must be seen, in pixels
        bool operator==(const Marks&) const = default;
    };
    Look look_;
    Marks marks_;
    Image overlay_colors_{0, 0};
    std::int64_t brushed_ = 0;

    /// What is outlined: a surface of which pictures.
    struct Outlined {
        std::optional<std::size_t> surface;
        std::uint64_t serial = 0;
        bool operator==(const Outlined&) const = default;
    };
    Outlined outlined_;
    std::vector<PixelBorder> lit_outline_;

    void update_overlay(const ViewerState& state, const Results& results);
    void update_outline(const ViewerState& state, const Results& results);
    std::optional<std::size_t> watched_;  ///< pixels, while the tracing is watched
};

}  // namespace glassbox
