#pragma once
#include <not_written.hpp>
#include <vec3.hpp>

namespace glassbox {

/// The side product of a ray's line and the line through A and B. Its sign tells on which side of each other they pass;
/// it is 0 where they meet. The ray starts at the origin, with direction D. Units are length² |D|.
///
/// A line with direction U through the point P has the Plücker coordinates π = (U, V), V = U × P, and the side product
/// of two lines is π_r ⊙ π_e = U_r·V_e + U_e·V_r. With the origin at the ray's start, V_r = D × 0 = 0; for the edge,
/// V_e = (B − A) × A = B × A. This leaves D·(B × A). (Platis and Theoharis 2003, and the paper's section 1.1.2.)
///
/// B × A = −(A × B) bit for bit, so two triangles that share the edge compute exactly opposite numbers: no ray slips
/// between them.
template <class Real>
constexpr Real side(const Vec3<Real>& D, const Vec3<Real>& A, const Vec3<Real>& B) {
    return not_written<Real>("side");
}

}  // namespace glassbox
