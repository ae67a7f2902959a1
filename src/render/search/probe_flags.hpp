#pragma once
#include <type_traits>

#include <probe.hpp>

namespace glassbox {

// A probe hears what it has an operator() for. By a flag, a `static constexpr bool`, it tells a search in advance what
// it does without, or asks for, so that the search may take a shorter way:
//
//   only_nearest   It does without the surfaces behind the first that is met: the search goes no further than that.
//   only_verdicts  It does without the tests themselves (told::Tested, Discriminant, Sides and the like) and hears only
//                  what comes of them (told::Met, Undecided): vectors may sort out what is surely missed.
//   hears_boxes    It asks for told::BoxOpened, of each box that the search looks into.
//
// No flag is needed to be told what is told anyway. Silent has the first two. A probe with both wants no more than a
// picture does: OnlyFirstHit.

template <class Probe>
concept OnlyNearest = std::is_same_v<std::remove_const_t<Probe>, Silent> || Probe::only_nearest;

template <class Probe>
concept OnlyVerdicts = std::is_same_v<std::remove_const_t<Probe>, Silent> || Probe::only_verdicts;

template <class Probe>
concept HearsBoxes = Probe::hears_boxes;

/// For such a probe the rays of neighbouring pixels may be traced together.
template <class Probe>
concept OnlyFirstHit = OnlyNearest<Probe> && OnlyVerdicts<Probe>;

}  // namespace glassbox
