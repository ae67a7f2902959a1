#pragma once
#include <map>
#include <vector>

#include "viewer/model/state/state.hpp"
#include "viewer/platform/window.hpp"

namespace glassbox {

/// What is seen while the view turns, a little at every frame; times in seconds.
struct Turning {
    double pictures = 0;                         ///< a second
    double median = 0, least = 0, greatest = 0;  ///< between one new picture and the next
    std::map<int, int> sizes;                    ///< how many had 1/factor of the whole one's width, by factor
    double processor = 0;                        ///< time a picture, of all threads, with the frames drawn meanwhile
};

/// How quickly the interface answers; times in seconds.
struct Quickness {
    double frame = 0, slowest_frame = 0;  ///< the median, while a picture is rendered in the background
    double pin_to_inspector = 0;          ///< from a click to the frame that shows the story; the median
    double slider_to_picture = 0;         ///< from a change of the light to the frame that shows a first picture
    Turning turning;
    double idle = 0;  ///< part of a core that is used while nothing happens
};

/// Measures it on the state's scene, in a window of this size that nobody sees. Takes some seconds.
Quickness quickness(ViewerState state, WindowSize size);

/// Measures only how the view turns.
Turning turning(ViewerState state, WindowSize size);

/// How long it takes, in seconds, from saving a learner's header to the frame that shows the new picture: once for each
/// of so many edits. The learner has the solution of the lesson that the state shows, in a folder that is gone
/// afterwards. Throws Error if the state shows no lesson, or its picture fails.
std::vector<double> saving_to_picture(ViewerState state, WindowSize size, int edits);

}  // namespace glassbox
