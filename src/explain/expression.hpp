#pragma once
#include <memory>
#include <string>
#include <vector>

/// Expressions as small trees, each with the text that it is written as.
namespace glassbox::formula {

/// How tightly a text holds together: what is looser than its place allows is put in parentheses.
enum class Binding { sum, quotient, vector_product, product, atom };

enum class Kind {
    leaf,        ///< a name, a number, or what no rule looks into
    component,   ///< of a vector: v.x
    sum,         ///< a + b
    difference,  ///< a − b
    negation,    ///< −a
    product,     ///< a b
    quotient,    ///< a / b
    square,      ///< a²
    power,       ///< a^b
    root,        ///< √a
    length,      ///< |v|
    dot,         ///< v·w
    cross,       ///< v × w
};

struct Node;
using Expression = std::shared_ptr<const Node>;

struct Node {
    Kind kind = Kind::leaf;
    std::string text;  ///< as it is written
    Binding binding = Binding::atom;
    std::vector<Expression> parts = {};
    char axis = 0;  ///< of a component: 'x', 'y' or 'z'
};

/// Whether both are written alike: then they are taken for the same.
bool operator==(const Node& a, const Node& b);

/// Its text, in parentheses if it is looser than that.
std::string in(const Expression& expression, Binding least);

Expression leaf(std::string text, Binding binding = Binding::atom);
Expression number(double value);
/// A name as it stands: "n·l" is a product, "a+b+c" a sum, "(A − P)" in parentheses already, "C.x" a component.
Expression name(const std::string& text);

Expression component(const Expression& vector, char axis);
Expression sum(const Expression& a, const Expression& b);
Expression difference(const Expression& a, const Expression& b);
Expression negation(const Expression& a);
Expression product(const Expression& a, const Expression& b);
Expression quotient(const Expression& a, const Expression& b);
Expression square(const Expression& a);
Expression power(const Expression& a, const Expression& exponent);
Expression root(const Expression& a);
Expression length(const Expression& vector);
Expression dot(const Expression& v, const Expression& w);
Expression cross(const Expression& v, const Expression& w);

}  // namespace glassbox::formula
