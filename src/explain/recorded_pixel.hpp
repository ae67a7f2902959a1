#pragma once
#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <ray.hpp>
#include <rgb.hpp>

#include "explain/source_file.hpp"
#include "numerics/tape.hpp"

namespace glassbox {

/// The test of a surface by another program, or what followed such a test where the surface is the one that is seen.
struct RecordedSurface {
    std::size_t number = 0;  ///< among all surfaces
    Tape tape;
    std::size_t test_steps = 0;  ///< how many of its steps are the test
    bool is_finished = false;    ///< otherwise the program ended while it recorded this
    CallNumber open_call = 0;    ///< in this call then
    bool met = false;
    double t = 0;
    std::optional<StepNumber> t_step;  ///< the step that made t; none for a constant
};

/// What another program recorded of a pixel, in double; perhaps not all, if it crashed.
struct RecordedPixel {
    Ray<double> ray;
    std::vector<RecordedSurface> tests;         ///< of some surfaces, in the order of their numbers
    std::size_t met = 0;                        ///< of all surfaces
    std::optional<Tape> ray_color;              ///< stage 1
    std::optional<RecordedSurface> hit;         ///< the surface that is seen: its test once more, and what follows
    std::optional<Rgb> color;                   ///< none if it did not get there
    std::string ended;                          ///< how it ended early, in words; "" if it did not
    std::shared_ptr<const OwnSources> sources;  ///< what its tapes point to; never null
};

}  // namespace glassbox
