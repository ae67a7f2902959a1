#include "explain/rewriting.hpp"

#include <optional>
#include <string>

namespace glassbox::formula {

namespace {

bool is_component(const Expression& expression) { return expression->kind == Kind::component; }

bool same_axis(const Expression& a, const Expression& b) {
    return is_component(a) && is_component(b) && a->axis == b->axis;
}

/// Products of components of two vectors. The axes of a dot product's are "xy" for v.x w.x + v.y w.y, that of a cross
/// product's one "yz" for v.y w.z.
struct Products {
    Expression v, w;
    std::string axes;
};

bool same_vectors(const Products& a, const Products& b) { return *a.v == *b.v && *a.w == *b.w; }

std::optional<Products> products_of_dot(const Expression& expression) {
    if (expression->kind == Kind::product) {
        const Expression &a = expression->parts[0], &b = expression->parts[1];
        if (same_axis(a, b)) return Products{vector_of(a), vector_of(b), {a->axis}};
    }
    if (expression->kind == Kind::sum) {
        const auto first = products_of_dot(expression->parts[0]), second = products_of_dot(expression->parts[1]);
        if (first && second && same_vectors(*first, *second))
            return Products{first->v, first->w, first->axes + second->axes};
    }
    return {};
}

std::optional<Products> product_of_cross(const Expression& expression) {
    if (expression->kind != Kind::product) return {};
    const Expression &a = expression->parts[0], &b = expression->parts[1];
    if (!is_component(a) || !is_component(b) || a->axis == b->axis) return {};
    return Products{vector_of(a), vector_of(b), {a->axis, b->axis}};
}

Expression rewritten_sum(const Expression& whole) {
    const Expression &a = whole->parts[0], &b = whole->parts[1];
    if (same_axis(a, b)) return component(sum(vector_of(a), vector_of(b)), a->axis);
    const auto products = products_of_dot(whole);
    if (!products || products->axes != "xyz") return whole;
    return *products->v == *products->w ? square(products->v) : dot(products->v, products->w);
}

/// v.y w.z − v.z w.y is (v × w).x: the axis is the one that does not occur.
Expression rewritten_difference(const Expression& whole) {
    const Expression &a = whole->parts[0], &b = whole->parts[1];
    if (same_axis(a, b)) return component(difference(vector_of(a), vector_of(b)), a->axis);
    const auto first = product_of_cross(a), second = product_of_cross(b);
    if (!first || !second || !same_vectors(*first, *second)) return whole;
    const char one = first->axes[0], other = first->axes[1];
    if (second->axes[0] != other || second->axes[1] != one) return whole;
    return component(cross(first->v, first->w), static_cast<char>('x' + 'y' + 'z' - one - other));
}

Expression rewritten_product(const Expression& whole) {
    const Expression &a = whole->parts[0], &b = whole->parts[1];
    if (is_component(a) && is_component(b)) return whole;
    if (is_component(a) || is_component(b))
        return component(rewritten_product(product(vector_of(a), vector_of(b))), is_component(a) ? a->axis : b->axis);
    return *a == *b ? square(a) : whole;
}

}  // namespace

const Expression& vector_of(const Expression& expression) {
    return is_component(expression) ? expression->parts[0] : expression;
}

bool is_part_of_product(const Expression& expression) {
    return products_of_dot(expression) || product_of_cross(expression);
}

Expression rewritten(const Expression& expression) {
    const auto& parts = expression->parts;
    switch (expression->kind) {
        case Kind::sum:
            return rewritten_sum(expression);
        case Kind::difference:
            return rewritten_difference(expression);
        case Kind::product:
            return rewritten_product(expression);
        case Kind::negation:
            return is_component(parts[0]) ? component(negation(vector_of(parts[0])), parts[0]->axis) : expression;
        case Kind::quotient:
            return is_component(parts[0]) ? component(quotient(vector_of(parts[0]), parts[1]), parts[0]->axis)
                                          : expression;
        case Kind::root:
            return parts[0]->kind == Kind::square ? length(parts[0]->parts[0]) : expression;
        default:
            return expression;
    }
}

}  // namespace glassbox::formula
