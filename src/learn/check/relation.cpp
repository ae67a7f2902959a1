#include "learn/check/relation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <iterator>
#include <numbers>
#include <set>

#include "learn/check/facts.hpp"

namespace glassbox::learn {
namespace relations {  // several files are compiled as one: these names are only ours

using Checks = std::vector<const CheckMade*>;

constexpr double tolerance = 1e-6;

bool close(double a, double b) {
    return a == b || (std::isnan(a) && std::isnan(b)) ||
           (std::isfinite(a) && std::isfinite(b) && std::abs(a - b) <= tolerance * std::max(std::abs(a), std::abs(b)));
}

double size_of(const std::vector<double>& v) {
    double sum = 0;
    for (const double x : v) sum = std::hypot(sum, x);
    return sum;
}

/// Whether two vectors, or two numbers, are as good as the same; small components beside large ones do not count.
bool close(const std::vector<double>& a, const std::vector<double>& b) {
    if (a.size() != b.size()) return false;
    const double most = tolerance * std::max(size_of(a), size_of(b));
    for (std::size_t i = 0; i < a.size(); ++i)
        if (!close(a[i], b[i]) && !(std::abs(a[i] - b[i]) <= most)) return false;
    return true;
}

std::vector<double> times(double factor, std::vector<double> v) {
    for (double& x : v) x *= factor;
    return v;
}

bool all_of(const std::vector<double>& v, const std::function<bool(double)>& is) {
    return std::all_of(v.begin(), v.end(), is);
}
bool any_of(const std::vector<double>& v, const std::function<bool(double)>& is) {
    return std::any_of(v.begin(), v.end(), is);
}

bool every(const Checks& wrong, const std::function<bool(const CheckMade&)>& is) {
    return std::all_of(wrong.begin(), wrong.end(), [&](const CheckMade* one) { return is(*one); });
}

bool is_finite(const std::vector<double>& v) {
    return all_of(v, [](double x) { return std::isfinite(x); });
}
bool is_zero(const std::vector<double>& v) {
    return all_of(v, [](double x) { return x == 0; });
}

std::string number(double x) {
    const double whole = std::round(x);
    return close(x, whole) ? fmt::format("{}", whole) : fmt::format("{:.4g}", x);
}

std::string shown(const std::vector<double>& v) {
    if (v.size() == 1) return number(v[0]);
    return fmt::format("({}, {}, {})", number(v[0]), number(v[1]), number(v[2]));
}

/// Whether so many of some checks expect something else each that what they have in common is hardly chance.
bool are_various(const Checks& wrong, std::size_t enough = 3) {
    std::set<std::vector<double>> expected;
    for (const CheckMade* one : wrong) expected.insert(one->expected);
    return expected.size() >= enough;
}

struct Factor {
    double number;
    std::string_view words;
};

/// The factors that mistakes make: a sign, a 2 or a 4, degrees for radians.
constexpr double pi = std::numbers::pi;
constexpr std::array factors{Factor{-1, "is minus what is expected: the sign is turned"},
                             Factor{0.5, "is half of what is expected"},
                             Factor{-0.5, "is minus half of what is expected"},
                             Factor{2, "is twice what is expected"},
                             Factor{-2, "is minus twice what is expected"},
                             Factor{3, "is 3 times what is expected"},
                             Factor{1 / 3.0, "is a third of what is expected"},
                             Factor{4, "is 4 times what is expected"},
                             Factor{0.25, "is a quarter of what is expected"},
                             Factor{pi, "is π times what is expected"},
                             Factor{1 / pi, "is what is expected, divided by π"},
                             Factor{2 * pi, "is 2π times what is expected"},
                             Factor{1 / (2 * pi), "is what is expected, divided by 2π"},
                             Factor{pi / 180, "is what is expected, times π/180"},
                             Factor{180 / pi, "is what is expected, times 180/π"}};

/// The factor between got and expected, if it is one of those, and the same everywhere.
std::string factor(const Checks& wrong) {
    for (const auto& [k, words] : factors)
        if (every(wrong, [&, k = k](const CheckMade& one) { return close(one.got, times(k, one.expected)); }))
            return std::string(words);
    return "";
}

/// Which components are wrong, of vectors, and how, where it is the same in all of them.
std::string components(const Checks& wrong) {
    constexpr std::array names{"x", "y", "z"};
    std::vector<std::string> differ;
    bool turned = true, only_zero = true;
    for (std::size_t i = 0; i < 3; ++i) {
        const auto is_right = [&](const CheckMade& one) { return close(one.got[i], one.expected[i]); };
        if (every(wrong, is_right)) continue;
        if (!every(wrong, [&](const CheckMade& one) { return !is_right(one); })) return "";
        differ.emplace_back(names[i]);
        Checks not_zero;
        std::ranges::copy_if(wrong, std::back_inserter(not_zero),
                             [&](const CheckMade* one) { return one->expected[i] != 0; });
        turned &= are_various(not_zero) &&
                  every(wrong, [&](const CheckMade& one) { return close(one.got[i], -one.expected[i]); });
        only_zero &= every(wrong, [&](const CheckMade& one) { return one.got[i] == 0; });
    }
    if (differ.empty() || differ.size() == 3) return "";
    return fmt::format("differs from what is expected in {} alone{}", fmt::join(differ, " and "),
                       turned      ? ", where the sign is turned"
                       : only_zero ? fmt::format(", which {} 0", differ.size() == 1 ? "is" : "are")
                                   : "");
}

/// Which components stand in each other's places.
std::string exchanged(const Checks& wrong) {
    constexpr std::array<std::array<std::size_t, 3>, 5> orders{{{1, 0, 2}, {2, 1, 0}, {0, 2, 1}, {1, 2, 0}, {2, 0, 1}}};
    constexpr std::array words{"has x and y exchanged", "has x and z exchanged", "has y and z exchanged",
                               "has y, z, x in the places of x, y, z", "has z, x, y in the places of x, y, z"};
    for (std::size_t k = 0; k < orders.size(); ++k)
        if (every(wrong, [&](const CheckMade& one) {
                for (std::size_t i = 0; i < 3; ++i)
                    if (!close(one.got[i], one.expected[orders[k][i]])) return false;
                return true;
            }))
            return words[k];
    return "";
}

std::string of_vectors(const Checks& wrong) {
    if (std::string words = exchanged(wrong); !words.empty()) return words;
    const auto along = [](const CheckMade& one, double sign) {
        const double is = size_of(one.got), should_be = size_of(one.expected);
        return is > 0 && should_be > 0 && close(times(sign / is, one.got), times(1 / should_be, one.expected));
    };
    if (every(wrong, [&](const CheckMade& one) { return along(one, 1); }))
        return every(wrong, [](const CheckMade& one) { return close(size_of(one.expected), 1); })
                   ? "has the right direction, but not the length 1"
                   : "has the right direction and the wrong length";
    if (every(wrong, [&](const CheckMade& one) { return along(one, -1); }))
        return "has the opposite direction, and another length";
    if (std::string words = components(wrong); !words.empty()) return words;
    if (every(wrong, [](const CheckMade& one) { return close(size_of(one.got), size_of(one.expected)); }))
        return "has the right length and the wrong direction";
    return "";
}

std::string of_numbers(const Checks& wrong) {
    const auto each = [&](const std::function<double(double)>& f) {
        return every(wrong, [&](const CheckMade& one) { return close(one.got[0], f(one.expected[0])); });
    };
    if (each([](double x) { return x * x; })) return "is the square of what is expected";
    if (each([](double x) { return std::sqrt(x); })) return "is the square root of what is expected";
    if (each([](double x) { return 1 / x; })) return "is 1 over what is expected";
    const double more = wrong[0]->got[0] - wrong[0]->expected[0];
    if (every(wrong, [&](const CheckMade& one) { return close(one.got[0], one.expected[0] + more); }))
        return fmt::format("is what is expected {} {}", more > 0 ? "plus" : "minus", number(std::abs(more)));
    return "";
}

/// Where what came out is one of the arguments.
std::string an_argument(const Checks& wrong, std::string_view function) {
    std::vector<OwnCall> calls;
    for (const CheckMade* one : wrong)
        if (auto call = own_call(*one, function)) calls.push_back(*std::move(call));
        else return "";
    for (const Input& candidate : calls[0].arguments) {
        bool same = true;
        for (std::size_t i = 0; i < wrong.size() && same; ++i) {
            const auto found = std::ranges::find(calls[i].arguments, candidate.name, &Input::name);
            same = found != calls[i].arguments.end() && found->numbers == wrong[i]->got && !is_zero(wrong[i]->got);
        }
        if (same) return fmt::format("is {}, unchanged", candidate.name);
    }
    return "";
}

std::string how_far(const Checks& wrong) {
    double most = 0;
    for (const CheckMade* one : wrong) {
        std::vector<double> off = one->got;
        for (std::size_t i = 0; i < off.size(); ++i) off[i] -= one->expected[i];
        const double size = size_of(one->expected);
        if (size == 0) return "";
        most = std::max(most, size_of(off) / size);
    }
    if (most > tolerance) return "";
    return fmt::format("is nearly right: off by rounding, by {:.1g} of its size or less", most * 1.05);
}

std::string too_large_or_small(const Checks& wrong, std::string_view function) {
    if (!every(wrong, [&](const CheckMade& one) { return own_call(one, function).has_value(); })) return "";
    const auto size = [](const std::vector<double>& v) { return v.size() == 1 ? v[0] : size_of(v); };
    const bool are_vectors = wrong[0]->got.size() == 3;
    if (every(wrong, [&](const CheckMade& one) { return size(one.got) > size(one.expected); }))
        return are_vectors ? "is too long" : "is too large";
    if (every(wrong, [&](const CheckMade& one) { return size(one.got) < size(one.expected); }))
        return are_vectors ? "is too short" : "is too small";
    return "";
}

/// What may be chance where few numbers are compared.
std::string of_various(const Checks& wrong, std::string_view function) {
    if (every(wrong, [&](const CheckMade& one) { return one.got == wrong[0]->got; }))
        return fmt::format("is {}", shown(wrong[0]->got));
    for (const auto& known : {factor, wrong[0]->got.size() == 3 ? of_vectors : of_numbers})
        if (std::string words = known(wrong); !words.empty()) return words;
    return an_argument(wrong, function);
}

std::string relation_of(const Checks& wrong, std::string_view function) {
    if (wrong.empty()) return "";
    const std::size_t count = wrong[0]->got.size();
    if (!every(wrong, [&](const CheckMade& one) {
            return count > 0 && one.got.size() == count && one.expected.size() == count;
        }))
        return "";
    const auto got = [&](bool (*is)(double)) {
        return every(wrong, [&](const CheckMade& one) { return any_of(one.got, is); });
    };
    if (got([](double x) { return std::isnan(x); })) return "is not a number";
    if (got([](double x) { return std::isinf(x); })) return "is infinite";
    if (!every(wrong, [](const CheckMade& one) { return is_finite(one.got) && is_finite(one.expected); })) return "";
    if (std::string words = how_far(wrong); !words.empty()) return words;
    const bool various = are_various(wrong);
    if (various)
        if (std::string words = of_various(wrong, function); !words.empty()) return words;
    if (count == 3 && are_various(wrong, 2))
        if (std::string words = components(wrong); !words.empty()) return words;
    return various ? too_large_or_small(wrong, function) : "";
}

}  // namespace relations

bool as_good_as_equal(double a, double b) { return relations::close(a, b); }

std::string relation_of(const std::vector<const CheckMade*>& wrong, std::string_view function) {
    return relations::relation_of(wrong, function);
}

}  // namespace glassbox::learn
