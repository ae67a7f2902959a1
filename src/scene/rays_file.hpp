#pragma once
#include <filesystem>
#include <vector>

#include <ray.hpp>

namespace glassbox {

/// Reads the rays of a CSV file with the header `ox,oy,oz,dx,dy,dz`: origin and direction, in decimal or hexadecimal
/// floats, `nan` and `inf` allowed. Throws Error with file, line and column for a row that is not six numbers.
std::vector<Ray<double>> read_rays(const std::filesystem::path& file);

}  // namespace glassbox
