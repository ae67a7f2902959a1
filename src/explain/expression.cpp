#include "explain/expression.hpp"

#include <utility>

#include "explain/phrases.hpp"

namespace glassbox::formula {

namespace {

Expression node(Kind kind, std::string text, Binding binding, std::vector<Expression> parts) {
    return std::make_shared<const Node>(Node{kind, std::move(text), binding, std::move(parts)});
}

}  // namespace

bool operator==(const Node& a, const Node& b) { return a.text == b.text && a.binding == b.binding; }

std::string in(const Expression& expression, Binding least) {
    return expression->binding >= least ? expression->text : '(' + expression->text + ')';
}

Expression leaf(std::string text, Binding binding) { return node(Kind::leaf, std::move(text), binding, {}); }

Expression number(double value) { return leaf(short_number(value), value < 0 ? Binding::sum : Binding::atom); }

Expression name(const std::string& text) {
    const std::size_t end = text.size() - 1;
    if (text.size() > 2 && text[end - 1] == '.' && text[end] >= 'x' && text[end] <= 'z')
        return component(name(text.substr(0, end - 1)), text[end]);
    if (text.front() == '(' || text.front() == '|') return leaf(text);
    if (text.find('+') != std::string::npos) return leaf(text, Binding::sum);
    return leaf(text, text.find("·") != std::string::npos ? Binding::vector_product : Binding::atom);
}

Expression component(const Expression& vector, char axis) {
    return std::make_shared<const Node>(
        Node{Kind::component, in(vector, Binding::atom) + '.' + axis, Binding::atom, {vector}, axis});
}

Expression sum(const Expression& a, const Expression& b) {
    return node(Kind::sum, in(a, Binding::sum) + " + " + in(b, Binding::quotient), Binding::sum, {a, b});
}

Expression difference(const Expression& a, const Expression& b) {
    return node(Kind::difference, in(a, Binding::sum) + " − " + in(b, Binding::quotient), Binding::sum, {a, b});
}

Expression negation(const Expression& a) {
    return node(Kind::negation, "−" + in(a, Binding::quotient), Binding::sum, {a});
}

Expression product(const Expression& a, const Expression& b) {
    return node(Kind::product, in(a, Binding::product) + ' ' + in(b, Binding::product), Binding::product, {a, b});
}

Expression quotient(const Expression& a, const Expression& b) {
    return node(Kind::quotient, in(a, Binding::quotient) + " / " + in(b, Binding::atom), Binding::quotient, {a, b});
}

Expression square(const Expression& a) { return node(Kind::square, in(a, Binding::atom) + "²", Binding::atom, {a}); }

Expression power(const Expression& a, const Expression& exponent) {
    return node(Kind::power, in(a, Binding::atom) + '^' + in(exponent, Binding::atom), Binding::atom, {a, exponent});
}

Expression root(const Expression& a) { return node(Kind::root, "√" + in(a, Binding::atom), Binding::atom, {a}); }

Expression length(const Expression& vector) {
    const std::string& text = vector->text;
    const bool in_parentheses = vector->binding == Binding::atom && text.front() == '(' && text.back() == ')';
    return node(Kind::length, '|' + (in_parentheses ? text.substr(1, text.size() - 2) : text) + '|', Binding::atom,
                {vector});
}

Expression dot(const Expression& v, const Expression& w) {
    return node(Kind::dot, in(v, Binding::atom) + "·" + in(w, Binding::atom), Binding::vector_product, {v, w});
}

Expression cross(const Expression& v, const Expression& w) {
    return node(Kind::cross, in(v, Binding::atom) + " × " + in(w, Binding::atom), Binding::vector_product, {v, w});
}

}  // namespace glassbox::formula
