#pragma once
#include "explain/expression.hpp"

namespace glassbox::formula {

/// The expression in the vectors that its components are of, where it comes to that: v.x w.x + v.y w.y + v.z w.z is
/// v·w, v.x + w.x is (v + w).x, √v² is |v|. Its parts are taken to be rewritten already.
Expression rewritten(const Expression& expression);

/// Whether it may yet become a dot or cross product: it is v.x w.x, or v.x w.x + v.y w.y, or v.y w.z.
bool is_part_of_product(const Expression& expression);

/// The vector that it is a component of, or else itself.
const Expression& vector_of(const Expression& expression);

}  // namespace glassbox::formula
