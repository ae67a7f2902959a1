#pragma once
#include <span>

#include "output/whole_file.hpp"
#include "render/shoot.hpp"

namespace glassbox {

/// Writes the CSV table of each ray's result, `ray,verdict,surface,t,t_error,decided,hits`: rays counted from 0; t in
/// the shortest form that reads back as the same number of its scalar; t_error rounded up. Fields without a meaning are
/// empty: surface and t of a miss, and t_error and decided for plain scalars, which guarantee nothing.
void hits_table(std::span<const Shot> shots, Scalar scalar, const Sink& sink);

}  // namespace glassbox
