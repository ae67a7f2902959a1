#include "viewer/model/story/symbols.hpp"

#include <fmt/format.h>

#include <optional>
#include <string_view>

#include "explain/phrases.hpp"
#include "explain/words.hpp"

namespace glassbox {

namespace {

using story::StoryStep;

/// How tightly a text holds together: what is looser than its place allows is put in parentheses.
enum Binding { sum, quotient, vector_product, product, atom };

struct Text {
    std::string text;
    Binding binding = atom;

    bool operator==(const Text&) const = default;
};

std::string in(const Text& text, Binding least) { return text.binding >= least ? text.text : '(' + text.text + ')'; }

std::string squared(const Text& text) { return in(text, atom) + "²"; }

/// A step as a part of formulas: a number, or a component of a vector, or a part of a dot or cross product to be.
struct Term {
    Text whole;                ///< of a number; of a component the vector
    std::optional<char> axis;  ///< of a component
    Text left, right;          ///< of a product of two components, or a sum of such: their vectors
    std::string axes;          ///< "xy": left.x × right.y; "x": left.x × right.x, "xyz" no longer a part
    enum { plain, dot_part, cross_part } kind = plain;
};

Text written(const Term& term) { return term.axis ? Text{in(term.whole, atom) + '.' + *term.axis, atom} : term.whole; }

Text number(double value) { return {short_number(value), value < 0 ? sum : atom}; }

Text dot(const Text& a, const Text& b) {
    if (a == b) return {squared(a), atom};
    return {in(a, atom) + "·" + in(b, atom), vector_product};
}

/// A name as it stands: "n·l" is a product, "a+b+c" a sum, "(A − P)" in parentheses already.
Text named(const std::string& name) {
    if (name.front() == '(' || name.front() == '|') return {name, atom};
    if (name.find('+') != std::string::npos) return {name, sum};
    return {name, name.find("·") != std::string::npos ? vector_product : atom};
}

Term term_named(const std::string& name) {
    const std::size_t end = name.size() - 1;
    if (name.size() > 2 && name[end - 1] == '.' && name[end] >= 'x' && name[end] <= 'z')
        return {.whole = named(name.substr(0, end - 1)), .axis = name[end], .left = {}, .right = {}, .axes = {}};
    return {.whole = named(name), .axis = {}, .left = {}, .right = {}, .axes = {}};
}

Term plain(Text text, std::optional<char> axis = {}) {
    return {.whole = std::move(text), .axis = axis, .left = {}, .right = {}, .axes = {}};
}

Text juxtaposed(const Text& a, const Text& b) {
    if (a == b) return {squared(a), atom};
    return {in(a, product) + ' ' + in(b, product), product};
}

Term times(const Term& a, const Term& b) {
    if (a.axis && b.axis) {
        Term part = plain({written(a).text + ' ' + written(b).text, product});
        part.left = a.whole;
        part.right = b.whole;
        part.kind = *a.axis == *b.axis ? Term::dot_part : Term::cross_part;
        part.axes = *a.axis == *b.axis ? std::string{*a.axis} : std::string{*a.axis, *b.axis};
        return part;
    }
    return plain(juxtaposed(a.whole, b.whole), a.axis ? a.axis : b.axis);
}

Term plus(const Term& a, const Term& b) {
    if (a.axis && a.axis == b.axis) return plain({in(a.whole, sum) + " + " + in(b.whole, quotient), sum}, a.axis);
    Term result = plain({in(written(a), sum) + " + " + in(written(b), quotient), sum});
    const bool goes_on = a.kind == Term::dot_part && b.kind == Term::dot_part && a.left == b.left && a.right == b.right;
    if (!goes_on) return result;
    result.axes = a.axes + b.axes;
    if (result.axes == "xyz") return plain(dot(a.left, a.right));
    result.kind = Term::dot_part;
    result.left = a.left;
    result.right = a.right;
    return result;
}

Term minus(const Term& a, const Term& b) {
    if (a.axis && a.axis == b.axis) return plain({in(a.whole, sum) + " − " + in(b.whole, quotient), sum}, a.axis);
    const bool cross = a.kind == Term::cross_part && b.kind == Term::cross_part && a.left == b.left &&
                       a.right == b.right && a.axes[0] == b.axes[1] && a.axes[1] == b.axes[0];
    if (cross) {
        const Text both{in(a.left, atom) + " × " + in(a.right, atom), vector_product};
        const auto third = static_cast<char>('x' + 'y' + 'z' - a.axes[0] - a.axes[1]);
        return plain(both, third);
    }
    return plain({in(written(a), sum) + " − " + in(written(b), quotient), sum});
}

/// √(a·a) is |a|.
Term root_of(const Term& a) {
    constexpr std::string_view square = "²";
    const std::string& text = a.whole.text;
    if (!a.axis && a.whole.binding == atom && text.ends_with(square)) {
        std::string inside = text.substr(0, text.size() - square.size());
        if (inside.front() == '(' && inside.back() == ')') inside = inside.substr(1, inside.size() - 2);
        return plain({'|' + inside + '|', atom});
    }
    return plain({"√" + in(written(a), atom), atom});
}

std::string operation_text(const StoryStep& told, const Text& a, const Text& b) {
    switch (told.step.operation) {
        case Operation::add:
        case Operation::subtract:
            return fmt::format("{} {} {}", in(a, sum), word(told.step.operation), in(b, quotient));
        case Operation::multiply:
        case Operation::divide:
            return fmt::format("{} {} {}", in(a, atom), word(told.step.operation), in(b, atom));
        case Operation::negate:
            return "−" + in(a, quotient);
        case Operation::square_root:
            return "√" + in(a, atom);
        case Operation::absolute:
            return '|' + a.text + '|';
        case Operation::power:
            return fmt::format("{} to the power {}", in(a, atom), in(b, atom));
        case Operation::round:
            return a.text + " rounded to the scalar";
        default:
            return fmt::format("{} {} {}", a.text, word(told.step.operation), b.text);
    }
}

Term result_of(const StoryStep& told, const Term& a, const Term& b) {
    switch (told.step.operation) {
        case Operation::add:
            return plus(a, b);
        case Operation::subtract:
            return minus(a, b);
        case Operation::multiply:
            return times(a, b);
        case Operation::divide:
            return plain({in(a.whole, quotient) + " / " + in(written(b), atom), quotient}, a.axis);
        case Operation::negate:
            return plain({"−" + in(a.whole, quotient), sum}, a.axis);
        case Operation::square_root:
            return root_of(a);
        case Operation::power:
            return plain({in(written(a), atom) + '^' + in(written(b), atom), atom});
        case Operation::round:
            return a;
        default:
            return plain({operation_text(told, written(a), written(b)), atom});
    }
}

/// Bytes of a text beyond which a value says more.
constexpr std::size_t longest = 90;

}  // namespace

std::vector<Symbol> symbols(std::span<const StoryStep> steps) {
    std::vector<Term> terms;
    std::vector<Symbol> all;
    terms.reserve(steps.size());
    all.reserve(steps.size());
    for (const StoryStep& told : steps) {
        const auto& [step, name, checked] = told;
        const bool starts = operands(step.operation) == 0;
        if (starts) {
            terms.push_back(name.empty() ? plain(number(checked.value)) : term_named(name));
            all.push_back({"", written(terms.back()).text, ""});
            continue;
        }
        const Term &a = terms[step.left], &b = terms[step.right];
        const Text left = written(a), right = written(b);
        Term term = result_of(told, a, b);
        const bool was_part = a.kind != Term::plain, is_part = term.kind != Term::plain;
        Symbol symbol{.result = {}, .written = {}, .formula = operation_text(told, left, right)};
        const std::string text = written(term).text;
        const std::string& better = was_part && !is_part ? text : symbol.formula;
        if (!name.empty()) symbol.result = fmt::format("{} = {}", name, name == better ? symbol.formula : better);
        else if (was_part && !is_part) symbol.result = text;
        if (!name.empty()) term = term_named(name);
        else if (term.whole.text.size() > longest) term = plain(number(checked.value), {});
        symbol.written = written(term).text;
        terms.push_back(std::move(term));
        all.push_back(std::move(symbol));
    }
    return all;
}

}  // namespace glassbox
