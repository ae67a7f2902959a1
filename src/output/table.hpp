#pragma once
#include <span>

#include "output/measured.hpp"
#include "output/whole_file.hpp"

namespace glassbox {

/// Writes a CSV table: the header x,y and the channels' names, then a row per pixel, in reading order from the top
/// left. Numbers are the shortest decimals that read back as the same double; a field is empty where there is no value;
/// infinity is written inf. All channels must have the same size.
void table(std::span<const Measured> measured, const Sink& sink);

}  // namespace glassbox
