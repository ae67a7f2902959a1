#include "explain/symbols.hpp"

#include <fmt/format.h>

#include <utility>

#include "explain/expression.hpp"
#include "explain/rewriting.hpp"
#include "explain/words.hpp"

namespace glassbox {

namespace {

using formula::Binding;
using formula::Expression;
using story::StoryStep;

/// The one operation, with its own sign.
std::string operation_text(Operation operation, const Expression& a, const Expression& b) {
    switch (operation) {
        case Operation::add:
        case Operation::subtract:
            return fmt::format("{} {} {}", in(a, Binding::sum), word(operation), in(b, Binding::quotient));
        case Operation::multiply:
        case Operation::divide:
            return fmt::format("{} {} {}", in(a, Binding::atom), word(operation), in(b, Binding::atom));
        case Operation::negate:
            return "−" + in(a, Binding::quotient);
        case Operation::square_root:
            return "√" + in(a, Binding::atom);
        case Operation::absolute:
            return '|' + a->text + '|';
        case Operation::power:
            return fmt::format("{} to the power {}", in(a, Binding::atom), in(b, Binding::atom));
        case Operation::round:
            return a->text + " rounded to the scalar";
        default:
            return fmt::format("{} {} {}", a->text, word(operation), b->text);
    }
}

/// The operation on expressions, as mathematics writes it.
Expression expression_of(Operation operation, const Expression& a, const Expression& b) {
    switch (operation) {
        case Operation::add:
            return formula::sum(a, b);
        case Operation::subtract:
            return formula::difference(a, b);
        case Operation::multiply:
            return formula::product(a, b);
        case Operation::divide:
            return formula::quotient(a, b);
        case Operation::negate:
            return formula::negation(a);
        case Operation::square_root:
            return formula::root(a);
        case Operation::power:
            return formula::power(a, b);
        case Operation::round:
            return a;
        default:
            return formula::leaf(operation_text(operation, a, b));
    }
}

/// Bytes of a text beyond which a value says more.
constexpr std::size_t longest = 90;

}  // namespace

std::vector<Symbol> symbols(std::span<const StoryStep> steps) {
    std::vector<Expression> expressions;
    std::vector<bool> shows_values;  // of those
    std::vector<Symbol> all;
    expressions.reserve(steps.size());
    all.reserve(steps.size());
    for (const auto& [step, name, checked] : steps) {
        if (operands(step.operation) == 0) {
            expressions.push_back(name.empty() ? formula::number(checked.value) : formula::name(name));
            shows_values.push_back(false);
            all.push_back({"", expressions.back()->text, ""});
            continue;
        }
        const Expression &a = expressions[step.left], &b = expressions[step.right];
        Expression expression = rewritten(expression_of(step.operation, a, b));
        const bool ends_product = is_part_of_product(a) && !is_part_of_product(expression);
        Symbol symbol{.result = {}, .written = {}, .formula = operation_text(step.operation, a, b)};
        symbol.has_values = shows_values[step.left] || shows_values[step.right];
        const bool is_too_long = name.empty() && vector_of(expression)->text.size() > longest;
        shows_values.push_back(name.empty() && (symbol.has_values || is_too_long));
        const std::string& better = ends_product ? expression->text : symbol.formula;
        if (!name.empty()) symbol.result = fmt::format("{} = {}", name, name == better ? symbol.formula : better);
        else if (ends_product) symbol.result = expression->text;
        if (!name.empty()) expression = formula::name(name);
        else if (is_too_long) expression = formula::number(checked.value);
        symbol.written = expression->text;
        expressions.push_back(std::move(expression));
        all.push_back(std::move(symbol));
    }
    return all;
}

}  // namespace glassbox
