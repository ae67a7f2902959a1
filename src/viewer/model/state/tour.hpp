#pragma once
#include <cstddef>
#include <optional>
#include <span>
#include <string_view>

namespace glassbox {

struct ViewerState;
enum class Page;

/// A part of the window.
enum class WindowPart { picture, truth, page, space, toolbar };

/// What the tour says of a part of the window.
struct TourStop {
    WindowPart part;
    std::optional<Page> page;  ///< that is shown meanwhile
    std::string_view title, text;
};

/// The tour, in order.
std::span<const TourStop> tour();

/// Goes to the first stop, to the one after, or to the one before; after the last one the tour is over.
void begin_tour(ViewerState& state);
void go_on_tour(ViewerState& state);
void go_back_on_tour(ViewerState& state);
void go_to_stop(ViewerState& state, std::size_t stop);  ///< counted from 0
void leave_tour(ViewerState& state);

}  // namespace glassbox
