#include "learn/check/facts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <optional>
#include <string_view>

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
    bool are_of_the_outcome = false;  ///< those that are added from now on

    void add(bool holds, std::string yes, std::string no) {
        all.push_back({std::move(yes), std::move(no), holds, are_of_the_outcome});
    }
    /// "x is 0", "x is not 0".
    void add_is(bool holds, const std::string& what, const std::string& is) {
        add(holds, what + " is " + is, what + " is not " + is);
    }
    void add_the_ray(bool holds, const std::string& does, const std::string& does_not) {
        add(holds, "the ray " + does, "the ray " + does_not);
    }
};

void add_direction(Facts& facts, const Vector& D) {
    facts.add_is(std::abs(size_of(D) - 1) < nearly, "|D|", "1");
    const int zeros = (D.x == 0) + (D.y == 0) + (D.z == 0);
    facts.add_the_ray(zeros == 2, "runs along an axis", "runs along no axis");
}

void add_sphere(Facts& facts, const Vector& P, const Vector& D, const Vector& c, double r) {
    const Vector v = P - c;
    const double away = size_of(v), off = size_of(cross(v, D)) / size_of(D);
    const bool on = std::abs(away - r) < nearly * r, inside = !on && away < r;
    const bool touches = std::abs(off - r) < nearly * r, passes = !touches && off > r;
    facts.add_the_ray(inside, "starts inside the sphere", "does not start inside the sphere");
    facts.add_the_ray(on, "starts on the sphere", "does not start on the sphere");
    facts.add(touches, "the ray's line touches the sphere", "the ray's line does not touch the sphere");
    facts.add(passes, "the ray's line passes by the sphere", "the ray's line does not pass by the sphere");
    facts.add(!inside && !on && !passes && dot(v, D) > 0, "the sphere lies behind the ray",
              "the sphere does not lie behind the ray");
    facts.add(!inside && !on && !passes && dot(v, D) < 0, "the sphere lies ahead of the ray",
              "the sphere does not lie ahead of the ray");
    add_direction(facts, D);
    facts.add(dot(v, D) == 0, "v·D is 0", "v·D is not 0");
    facts.add(dot(v, D) > 0, "v·D is positive", "v·D is not positive");
    facts.add(off < nearly * r, "the ray's line goes through the centre", "the ray's line passes beside the centre");
    facts.add(size_of(c) == 0, "the centre is the origin", "the centre is not the origin");
    facts.add_is(r == 1, "the radius", "1");
    facts.add(size_of(P) == 0, "the ray starts in the origin", "the ray does not start in the origin");
}

void add_triangle(Facts& facts, const Vector& P, const Vector& D, const std::vector<double>& corners) {
    const Vector A = vector_at(corners, 0), B = vector_at(corners, 3), C = vector_at(corners, 6);
    const Vector n = cross(B - A, C - A);
    const double across = dot(n, D), flat = nearly * size_of(n) * size_of(D);
    const bool edge_on = std::abs(across) <= flat;
    facts.add(size_of(n) == 0, "the triangle has no area", "the triangle has an area");
    facts.add(edge_on, "the triangle is seen edge-on, or has no area", "the triangle is not seen edge-on");
    facts.add(across > flat, "the triangle is seen from behind (clockwise)",
              "the triangle is not seen from behind (clockwise)");
    facts.add(across < -flat, "the triangle is seen from the front (counter-clockwise)",
              "the triangle is not seen from the front (counter-clockwise)");
    if (!edge_on) {
        const double t = dot(n, A - P) / across;
        const Vector hit = P + t * D;
        const double whole = dot(n, n);
        const double a = dot(n, cross(B - hit, C - hit)) / whole, b = dot(n, cross(C - hit, A - hit)) / whole,
                     c = dot(n, cross(A - hit, B - hit)) / whole;
        const double least = std::min({a, b, c});
        const int zeros = (std::abs(a) < nearly) + (std::abs(b) < nearly) + (std::abs(c) < nearly);
        const bool inside = least > nearly, outside = least < -nearly;
        facts.add(outside, "the ray's line passes beside the triangle", "the ray's line meets the triangle");
        facts.add(inside, "the ray's line passes well inside the triangle",
                  "the ray's line does not pass well inside the triangle");
        facts.add(!outside && zeros == 1, "the ray's line meets an edge of the triangle",
                  "the ray's line does not meet an edge of the triangle");
        facts.add(!outside && zeros == 2, "the ray's line meets a vertex of the triangle",
                  "the ray's line does not meet a vertex of the triangle");
        facts.add(t < 0, "the triangle's plane lies behind the ray",
                  "the triangle's plane does not lie behind the ray");
        facts.add(t == 0, "the ray starts in the triangle's plane", "the ray does not start in the triangle's plane");
    }
    add_direction(facts, D);
}

void add_number(Facts& facts, const std::string& name, double x) {
    if (std::isnan(x) || std::isinf(x)) {
        facts.add_is(std::isnan(x), name, "not a number");
        facts.add_is(std::isinf(x), name, "infinite");
        return;
    }
    facts.add_is(x == 0, name, "0");
    facts.add_is(x < 0, name, "negative");
    facts.add_is(x > 0, name, "positive");
    facts.add_is(x == 1, name, "1");
    facts.add_is(std::abs(x) > 1, "|" + name + "|", "above 1");
    facts.add_is(x == std::trunc(x), name, "whole");
}

void add_vector(Facts& facts, const std::string& name, const Vector& v) {
    const double size = size_of(v);
    if (!std::isfinite(size)) return;
    facts.add_is(size == 0, name, "zero");
    facts.add_is(std::abs(size - 1) < nearly, "|" + name + "|", "1");
    facts.add(v.x == 0 || v.y == 0 || v.z == 0, "a component of " + name + " is 0",
              "no component of " + name + " is 0");
    facts.add(v.x < 0 || v.y < 0 || v.z < 0, "a component of " + name + " is negative",
              "no component of " + name + " is negative");
    for (const auto& [axis, number] : {std::pair{".x", v.x}, {".y", v.y}, {".z", v.z}}) {
        facts.add_is(number == 0, name + axis, "0");
        facts.add_is(number < 0, name + axis, "negative");
        facts.add_is(number > 0, name + axis, "positive");
    }
}

void add_pair(Facts& facts, const Input& one, const Input& other) {
    if (one.numbers.size() != other.numbers.size()) return;
    const auto both = [&](const char* are) { return fmt::format("{} and {} are {}", one.name, other.name, are); };
    facts.add(one.numbers == other.numbers, both("equal"), both("not equal"));
    if (one.numbers.size() == 1) {
        facts.add(one.numbers[0] < other.numbers[0], fmt::format("{} < {}", one.name, other.name),
                  fmt::format("{} >= {}", one.name, other.name));
        facts.add(one.numbers[0] > other.numbers[0], fmt::format("{} > {}", one.name, other.name),
                  fmt::format("{} <= {}", one.name, other.name));
        return;
    }
    const Vector a = vector_at(one.numbers, 0), b = vector_at(other.numbers, 0);
    const double cosine = dot(a, b), size = size_of(a) * size_of(b);
    if (!std::isfinite(size)) return;
    facts.add(std::abs(cosine) <= nearly * size, both("at right angles"), both("not at right angles"));
    facts.add(cosine < 0, fmt::format("{}·{} is negative", one.name, other.name),
              fmt::format("{}·{} is not negative", one.name, other.name));
    facts.add(size_of(cross(a, b)) <= nearly * size, both("parallel"), both("not parallel"));
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

/// The arguments that are written out in an expression's call, if it is one, and maybe members of it.
std::vector<Input> written_inputs(const std::string& expression) {
    const std::size_t open = expression.find('(');
    if (open == std::string::npos || open == 0) return {};
    for (const char c : expression.substr(0, open))
        if (!std::isalnum(static_cast<unsigned char>(c)) && std::string_view("_:<>").find(c) == std::string_view::npos)
            return {};
    int depth = 0;
    std::size_t close = open;
    for (; close < expression.size(); ++close) {
        depth += expression[close] == '(';
        depth -= expression[close] == ')';
        if (depth == 0) break;
    }
    for (const char c : expression.substr(std::min(close + 1, expression.size())))
        if (!std::isalnum(static_cast<unsigned char>(c)) && c != '.' && c != '_') return {};
    std::string called = expression.substr(0, open);
    called = called.substr(0, called.find('<'));
    constexpr const char* places[] = {"first", "second", "third", "fourth"};
    std::vector<Input> all;
    const auto parts = parts_of(std::string_view(expression).substr(open + 1, close - open - 1));
    for (std::size_t i = 0; i < parts.size() && i < std::size(places); ++i)
        if (std::vector<double> numbers = numbers_written(parts[i]); !numbers.empty())
            all.push_back({fmt::format("{}'s {} argument", called, places[i]), std::move(numbers)});
    return all;
}

/// Whether a variable is what is checked, or another member of that: of `roots.t0` it is `roots.t1`.
bool is_outcome(const Input& input, const std::string& expression) {
    const std::string variable = input.name.substr(0, input.name.find('.'));
    return expression == variable || expression.starts_with(variable + '.') || expression.starts_with(variable + "->");
}

void add_inputs(Facts& facts, const std::vector<Input>& inputs) {
    for (const Input& one : inputs) {
        if (one.numbers.size() == 1) add_number(facts, one.name, one.numbers[0]);
        if (one.numbers.size() == 3) add_vector(facts, one.name, vector_at(one.numbers, 0));
    }
    for (std::size_t i = 0; i < inputs.size(); ++i)
        for (std::size_t k = i + 1; k < inputs.size(); ++k) add_pair(facts, inputs[i], inputs[k]);
}

std::vector<Fact> facts_of(const CheckMade& check) {
    Facts facts;
    if (check.ray.size() == 6) {
        const Vector P = vector_at(check.ray, 0), D = vector_at(check.ray, 3);
        if (check.surface.size() == 4) add_sphere(facts, P, D, vector_at(check.surface, 0), check.surface[3]);
        if (check.surface.size() == 9) add_triangle(facts, P, D, check.surface);
    }
    std::vector<Input> inputs = written_inputs(check.expression), outcomes;
    for (const Input& one : check.inputs) (is_outcome(one, check.expression) ? outcomes : inputs).push_back(one);
    add_inputs(facts, inputs);
    facts.are_of_the_outcome = true;
    const std::size_t dot = check.expression.rfind('.');
    if (dot != std::string::npos && check.expression.find_first_of(" )(", dot) == std::string::npos) {
        const std::string member = check.expression.substr(dot + 1);
        facts.add(true, fmt::format("`{}` is checked", member), "");
    }
    std::erase_if(outcomes, [&](const Input& one) { return one.name == check.expression; });
    add_inputs(facts, outcomes);
    if (check.is_condition && check.expected.size() == 1)
        facts.add(check.expected[0] == 1, "the right answer is yes", "the right answer is no");
    else if (check.expected.size() == 1) add_number(facts, "what is expected", check.expected[0]);
    else if (check.expected.size() == 3) add_vector(facts, "what is expected", vector_at(check.expected, 0));
    return facts.all;
}

}  // namespace facts

std::vector<Fact> facts_of(const CheckMade& check) { return facts::facts_of(check); }

}  // namespace glassbox::learn
