#pragma once

/// What the probe is told while a point is shaded. It stands apart from the formulas, so that what only listens is not
/// compiled again when they change.
namespace glassbox::told {

struct NormalLight {};   ///< n·l, the cosine of the angle between normal and light
struct NormalViewer {};  ///< n·r, r the unit vector towards the viewer
struct HalfVector {};    ///< h
struct NormalHalf {};    ///< n·h
struct Reflection {};    ///< (m, r·m), m the reflected light of Phong's original model
struct Ambient {};       ///< k_a
struct DiffuseTerm {};   ///< I k_d max(0, n·l)
struct SpecularTerm {};  ///< I k_s max(0, n·h)^e

}  // namespace glassbox::told
