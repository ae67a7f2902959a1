#pragma once
#include <cstdint>

#include "viewer/model/results.hpp"
#include "viewer/model/state.hpp"
#include "viewer/platform/texture.hpp"

namespace glassbox {

/// The computed pictures as textures, renewed when there is something newer.
class Pictures {
public:
    void update(const ViewerState& state, const Results& results);

    const Texture& picture() const { return picture_; }
    const Texture& overlay() const { return overlay_; }        ///< a measurement's colours
    const Texture& other() const { return other_; }            ///< another scalar's or rule's picture
    const Texture& difference() const { return difference_; }  ///< between the two

private:
    Texture picture_, overlay_, other_, difference_;
    std::uint64_t picture_serial_ = 0, overlay_serial_ = 0, other_serial_ = 0, difference_serial_ = 0;
    Overlay overlay_choice_;
    std::size_t watched_ = 0;
};

}  // namespace glassbox
