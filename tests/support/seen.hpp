#pragma once
#include <array>
#include <concepts>
#include <initializer_list>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

/// The variables that a check is made from. `glassbox learn` writes them into its copy of a test's source
/// (learn/check/seen_variables.hpp), so that it can tell with which inputs a check passes, and with which it fails.
namespace glassbox::test {

/// A number or a vector, with the name that it has in the test: "ray.D".
struct Named {
    std::string name;
    std::array<double, 3> numbers{};
    int count = 1;  ///< how many of those
};

/// Adds a variable's numbers, member by member; nothing for what has none that we know of.
template <class T>
void add_named(std::vector<Named>& all, const std::string& name, const T& value) {
    if constexpr (std::is_arithmetic_v<T> || std::is_enum_v<T>) {
        all.push_back({name, {static_cast<double>(value)}, 1});
    } else if constexpr (requires {
                             { value.x } -> std::convertible_to<long double>;
                             { value.y } -> std::convertible_to<long double>;
                             { value.z } -> std::convertible_to<long double>;
                         }) {
        const auto number = [](const auto& one) { return static_cast<double>(one); };
        all.push_back({name, {number(value.x), number(value.y), number(value.z)}, 3});
    } else if constexpr (requires { value.has_value(); }) {
        if (value.has_value()) add_named(all, name, *value);
    } else {
        const auto add = [&](const char* member, const auto& of) { add_named(all, name + '.' + member, of); };
        if constexpr (requires { value.P, value.D; }) add("P", value.P), add("D", value.D);
        if constexpr (requires { value.A, value.B, value.C; }) add("A", value.A), add("B", value.B), add("C", value.C);
        if constexpr (requires { value.r; }) add("C", value.C), add("r", value.r);
        if constexpr (requires { value.a, value.b, value.c; }) add("a", value.a), add("b", value.b), add("c", value.c);
        if constexpr (requires { value.met, value.t; }) add("met", value.met), add("t", value.t);
        if constexpr (requires { value.real; }) add("real", value.real);
        if constexpr (requires { value.t0, value.t1; }) add("t0", value.t0), add("t1", value.t1);
        if constexpr (requires { value.surface, value.t; }) add("surface", value.surface), add("t", value.t);
        if constexpr (requires { value.enters, value.leaves; })
            add("enters", value.enters), add("leaves", value.leaves);
        if constexpr (requires { value.l, value.intensity; }) add("l", value.l), add("intensity", value.intensity);
    }
}

/// A variable of a test, to be looked at when a check is made.
struct SeenVariable {
    const char* name;
    const void* at;
    void (*add)(std::vector<Named>& all, const std::string& name, const void* at);
};

template <class T>
SeenVariable variable(const char* name, const T& value) {
    return {name, &value, [](std::vector<Named>& all, const std::string& called, const void* at) {
                add_named(all, called, *static_cast<const T*>(at));
            }};
}

/// The variables of the check that is being made. Lives as long as that.
class Seen {
public:
    Seen(int line, std::initializer_list<SeenVariable> variables) : line_(line), before_(now()) {
        for (const SeenVariable& one : variables)
            if (count_ < variables_.size()) variables_[count_++] = one;
        now() = this;
    }
    Seen(const Seen&) = delete;
    Seen& operator=(const Seen&) = delete;
    ~Seen() { now() = before_; }

    /// The one that was made last and still lives; null if there is none.
    static const Seen*& now() {
        static const Seen* last = nullptr;
        return last;
    }

    int line() const { return line_; }
    std::vector<Named> named() const {
        std::vector<Named> all;
        for (std::size_t i = 0; i < count_; ++i) variables_[i].add(all, variables_[i].name, variables_[i].at);
        return all;
    }

private:
    int line_;
    const Seen* before_;
    std::array<SeenVariable, 8> variables_{};
    std::size_t count_ = 0;
};

}  // namespace glassbox::test
