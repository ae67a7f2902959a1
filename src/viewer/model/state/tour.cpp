#include "viewer/model/state/tour.hpp"

#include <iterator>

#include "viewer/model/state/state.hpp"

namespace glassbox {

namespace {

constexpr TourStop stops[] = {
    {WindowPart::picture, std::nullopt, "A pixel is a ray",
     "Every pixel of this picture is one ray, and the frame marks the one that is pinned. Click another pixel, or move "
     "the pin by "
     "the arrow keys. The wheel zooms in, until each pixel shows its numbers; F fits the picture again."},
    {WindowPart::truth, std::nullopt, "Is it right?",
     "Is what the pixel shows what is truly there, and how sure is that? Below: how many surfaces were tested, the "
     "angles "
     "of the light, and the number that came nearest to failing. Click one of these to see where it comes from."},
    {WindowPart::page, Page::inspector, "All its numbers",
     "The story of the pinned pixel, from its ray to its colour: every test, every number with its error bound. Where "
     "0 lies "
     "within the bound, the sign is not proven."},
    {WindowPart::page, Page::steps, "Step by step",
     "The same as the computer did it: one operation after the other, each with its line of source. ] steps forward, [ "
     "back, "
     "c jumps to the next subtraction that loses bits."},
    {WindowPart::page, Page::overlay, "Where it is in danger",
     "Lay a measurement over the picture: how many tests a pixel took, how near its signs came to being wrong, how "
     "many bits "
     "were lost. What is bright needs a look."},
    {WindowPart::space, std::nullopt, "The scene in space",
     "The pinned ray, what it meets and the vectors at its first hit. Drag to look from elsewhere, the wheel comes "
     "closer."},
    {WindowPart::toolbar, Page::controls, "Now you",
     "Turn the view, move the light, compute in float instead: everything follows, and Ctrl+Z takes it back. Open… has "
     "more "
     "scenes, ? all keys, and Tour this tour."},
};

}  // namespace

std::span<const TourStop> tour() { return stops; }

void go_to_stop(ViewerState& state, std::size_t stop) {
    state.tour = stop;
    if (stops[stop].page) state.page = *stops[stop].page;
    if (stops[stop].part == WindowPart::space) state.space_shown = true;
}

void begin_tour(ViewerState& state) { go_to_stop(state, 0); }

void go_on_tour(ViewerState& state) {
    if (!state.tour) return;
    if (*state.tour + 1 < std::size(stops)) go_to_stop(state, *state.tour + 1);
    else leave_tour(state);
}

void go_back_on_tour(ViewerState& state) {
    if (state.tour && *state.tour > 0) go_to_stop(state, *state.tour - 1);
}

void leave_tour(ViewerState& state) { state.tour.reset(); }

}  // namespace glassbox
