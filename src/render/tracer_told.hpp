#pragma once

/// What the probe is told by the tracer itself.
namespace glassbox::told {

struct Nearest {};        ///< (surface, t): the nearest hit
struct SurfaceNormal {};  ///< the unit normal there

}  // namespace glassbox::told
