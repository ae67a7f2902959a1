#include "learn/check/facts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <utility>

#include <vec3.hpp>

namespace glassbox::learn {
namespace facts {  // several files are compiled as one: these names are only ours

constexpr double nearly = 1e-9;  // of a length: what rounding may do to a test's numbers

using Vector = Vec3<double>;

/// |a|, where squares would overflow or underflow, too.
double size_of(const Vector& a) { return std::hypot(a.x, a.y, a.z); }

Vector vector_at(const std::vector<double>& numbers, std::size_t at) {
    return {numbers[at], numbers[at + 1], numbers[at + 2]};
}

class Facts {
public:
    std::vector<Fact> all;

    void add(bool holds, std::string yes, std::string no, bool is_special = false) {
        all.push_back({std::move(yes), std::move(no), holds, is_special});
    }
    /// "x is 0", "x is not 0".
    void add_is(bool holds, const std::string& what, const std::string& is, bool is_special = false) {
        add(holds, what + " is " + is, what + " is not " + is, is_special);
    }
    /// "a component of v is 0", "no component of v is 0".
    void add_any(bool holds, const std::string& what, const std::string& is, bool is_special = false) {
        add(holds, fmt::format("a component of {} is {}", what, is), fmt::format("no component of {} is {}", what, is),
            is_special);
    }
};

constexpr bool special = true;  // for Fact::is_special

void add_number(Facts& facts, const std::string& name, double x) {
    facts.add(std::isnan(x), name + " is not a number", name + " is a number", special);
    facts.add_is(std::isinf(x), name, "infinite", special);
    facts.add_is(x == 0, name, "0", special);
    facts.add_is(x < 0, name, "negative");
    facts.add_is(x > 0, name, "positive");
}

void add_vector(Facts& facts, const std::string& name, const Vector& v) {
    const auto any = [&](bool (*is)(double)) { return is(v.x) || is(v.y) || is(v.z); };
    facts.add_is(v == Vector{}, name, "zero", special);
    facts.add(any([](double x) { return std::isnan(x); }), fmt::format("a component of {} is not a number", name),
              fmt::format("all components of {} are numbers", name), special);
    facts.add_any(any([](double x) { return std::isinf(x); }), name, "infinite", special);
    facts.add_any(any([](double x) { return x == 0; }), name, "0", special);
    facts.add(std::abs(size_of(v) - 1) < nearly, name + " has length 1", name + " has another length than 1");
    facts.add_any(any([](double x) { return x < 0; }), name, "negative");
}

void add_pair(Facts& facts, const Input& one, const Input& other) {
    if (one.numbers.size() != other.numbers.size()) return;
    const auto both = [&](const char* are) { return fmt::format("{} and {} are {}", one.name, other.name, are); };
    facts.add(one.numbers == other.numbers, both("equal"), both("not equal"), special);
    if (one.numbers.size() == 1) {
        const double a = one.numbers[0], b = other.numbers[0];
        const auto than = [&](const char* is) { return fmt::format("{} is {} than {}", one.name, is, other.name); };
        facts.add(a < b, than("less"), than("not less"));
        facts.add(a > b, than("more"), than("not more"));
        return;
    }
    const Vector a = vector_at(one.numbers, 0), b = vector_at(other.numbers, 0);
    const double cosine = dot(a, b), size = size_of(a) * size_of(b);
    facts.add(std::abs(cosine) <= nearly * size, both("at right angles"), both("not at right angles"));
    facts.add(cosine < -nearly * size, both("more than a right angle apart"),
              both("not more than a right angle apart"));
    facts.add(size_of(cross(a, b)) <= nearly * size, both("parallel"), both("not parallel"));
}

std::vector<Fact> facts_of(const std::vector<Input>& arguments) {
    Facts facts;
    for (const Input& one : arguments) {
        if (one.numbers.size() == 1) add_number(facts, one.name, one.numbers[0]);
        if (one.numbers.size() == 3) add_vector(facts, one.name, vector_at(one.numbers, 0));
    }
    for (std::size_t i = 0; i < arguments.size(); ++i)
        for (std::size_t k = i + 1; k < arguments.size(); ++k) add_pair(facts, arguments[i], arguments[k]);
    return std::move(facts.all);
}

// What an expression is written with: first_of(Real(-7), Real(3)).t has -7 and 3.

std::string_view trimmed(std::string_view text) {
    while (!text.empty() && std::isspace(static_cast<unsigned char>(text.front()))) text.remove_prefix(1);
    while (!text.empty() && std::isspace(static_cast<unsigned char>(text.back()))) text.remove_suffix(1);
    return text;
}

/// The parts between commas at the top level.
std::vector<std::string_view> parts_of(std::string_view list) {
    std::vector<std::string_view> parts;
    int depth = 0;
    std::size_t begin = 0;
    for (std::size_t i = 0; i < list.size(); ++i) {
        if (std::string_view("({[").find(list[i]) != std::string_view::npos) ++depth;
        if (std::string_view(")}]").find(list[i]) != std::string_view::npos) --depth;
        if (list[i] != ',' || depth != 0) continue;
        parts.push_back(trimmed(list.substr(begin, i - begin)));
        begin = i + 1;
    }
    parts.push_back(trimmed(list.substr(begin)));
    return parts;
}

/// -3, Real(0.5), Real(2) / 7.
std::optional<double> number_written(std::string_view text) {
    text = trimmed(text);
    if (text.starts_with("Real(") && text.find(')') == text.size() - 1) text = text.substr(5, text.size() - 6);
    double number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc{}) return {};
    const std::string_view rest = text.substr(static_cast<std::size_t>(end - text.data()));
    return rest.empty() || rest == "f" ? std::optional(number) : std::nullopt;
}

/// Vec3<Real>{1, 2, 3}, or one number.
std::vector<double> numbers_written(std::string_view text) {
    if (const auto number = number_written(text)) return {*number};
    constexpr std::string_view opening = "Vec3<Real>{";
    if (!text.starts_with(opening) || !text.ends_with('}')) return {};
    std::vector<double> all;
    for (const std::string_view part : parts_of(text.substr(opening.size(), text.size() - opening.size() - 1)))
        if (const auto number = number_written(part)) all.push_back(*number);
        else return {};
    return all.size() == 3 ? all : std::vector<double>{};
}

/// The name by which code calls a function that an exercise calls so; "" for an operator.
std::string_view called_in_code(std::string_view function) {
    const std::size_t end = function.find(' ');
    return end == std::string_view::npos || function.substr(end).starts_with(" of ") ? function.substr(0, end)
                                                                                     : std::string_view();
}

/// The name that stands before a call's parenthesis, without namespaces and template arguments.
std::string_view bare_name(std::string_view before) {
    before = before.substr(0, before.find('<'));
    const std::size_t colons = before.rfind("::");
    return colons == std::string_view::npos ? before : before.substr(colons + 2);
}

/// What is known of an argument: the numbers that are written there, or those of a variable and its members.
void add_argument(std::vector<Input>& all, std::string_view written, const std::string& name, const CheckMade& check) {
    if (std::vector<double> numbers = numbers_written(written); !numbers.empty()) {
        all.push_back({name, std::move(numbers)});
        return;
    }
    for (const Input& one : check.inputs) {
        if (one.name == written) all.push_back({name, one.numbers});
        else if (one.name.starts_with(std::string(written) + '.'))
            all.push_back({fmt::format("{} of {}", one.name.substr(written.size() + 1), name), one.numbers});
    }
}

std::optional<OwnCall> own_call(const CheckMade& check, std::string_view function) {
    const std::string_view expression = check.expression, name = called_in_code(function);
    const std::size_t open = expression.find('(');
    if (name.empty() || open == std::string_view::npos || bare_name(expression.substr(0, open)) != name) return {};
    int depth = 0;
    std::size_t close = open;
    for (; close < expression.size(); ++close) {
        depth += expression[close] == '(';
        depth -= expression[close] == ')';
        if (depth == 0) break;
    }
    if (close == expression.size()) return {};
    const std::string_view after = expression.substr(close + 1);
    const auto in_a_member = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '.' || c == '_'; };
    if (!std::ranges::all_of(after, in_a_member)) return {};
    constexpr std::array places{"first", "second", "third", "fourth"};
    const auto parts = parts_of(expression.substr(open + 1, close - open - 1));
    OwnCall call{{}, after.empty()};
    for (std::size_t i = 0; i < std::min(parts.size(), places.size()); ++i)
        add_argument(call.arguments, parts[i],
                     parts.size() == 1 ? "its argument" : fmt::format("its {} argument", places[i]), check);
    return call;
}

std::string member_checked(const CheckMade& check) {
    const std::string_view expression = check.expression;
    const auto in_a_name = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_'; };
    std::size_t begin = expression.size();
    while (begin > 0 && in_a_name(expression[begin - 1])) --begin;
    const std::string_view before = expression.substr(0, begin);
    const bool is_member =
        before.ends_with("->") || (before.ends_with('.') && before.size() > 1 &&
                                   !std::isdigit(static_cast<unsigned char>(before[before.size() - 2])));
    return is_member ? std::string(expression.substr(begin)) : "";
}

}  // namespace facts

std::optional<OwnCall> own_call(const CheckMade& check, std::string_view function) {
    return facts::own_call(check, function);
}
std::string member_checked(const CheckMade& check) { return facts::member_checked(check); }
std::vector<Fact> facts_of(const std::vector<Input>& arguments) { return facts::facts_of(arguments); }

}  // namespace glassbox::learn
