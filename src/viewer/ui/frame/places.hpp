#pragma once
#include "viewer/model/state/tour.hpp"
#include "viewer/ui/panels.hpp"

namespace glassbox {

/// A rectangle of the screen.
struct Area {
    ImVec2 from, to;
};

/// Where the parts of the window lie in this frame.
struct Places {
    Area picture, truth, page, space, toolbar;
};

inline const Area& area_of(const Places& places, WindowPart part) {
    switch (part) {
        case WindowPart::picture:
            return places.picture;
        case WindowPart::truth:
            return places.truth;
        case WindowPart::page:
            return places.page;
        case WindowPart::space:
            return places.space;
        case WindowPart::toolbar:
            return places.toolbar;
    }
    return places.picture;
}

void draw_tour(const Frame& frame, const Places& places);  ///< the present stop, if there is one

}  // namespace glassbox
