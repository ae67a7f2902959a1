#pragma once
#include <span>
#include <string>
#include <vector>

#include "explain/story.hpp"

namespace glassbox {

/// How a step is written in the names of the numbers that it comes from.
struct Symbol {
    std::string result;   ///< "a = D·((C − P) × (B − P))", where the step has a name or ends a vector operation
    std::string written;  ///< how formulas that go on from it write it: "a"
    std::string formula;  ///< the one operation: "D.x × ((C − P) × (B − P)).x"
    bool has_values = false;  ///< whether something in it was too long, and is written as its value
};

/// The symbols of all steps of a tape, found from the tape alone: three products and two sums of matching components
/// are a dot product, and so on. What would become too long is written as its value.
std::vector<Symbol> symbols(std::span<const story::StoryStep> steps);

}  // namespace glassbox
