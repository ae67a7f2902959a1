#pragma once
#include <array>
#include <concepts>
#include <initializer_list>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

/// The variables that a check is made from. `glassbox learn` writes them into its copy of a test's source
/// (learn/check/seen_variables.hpp), so that it can tell with which inputs a check passes, and with which it fails.
/// What can be is in seen.cpp, which is compiled once: a learner waits for the tests to compile after each change.
namespace glassbox::test {

/// A number or a vector, with the name that it has in the test: "ray.D".
struct Named {
    std::string name;
    std::array<double, 3> numbers{};
    int count = 1;  ///< how many of those
};

/// The numbers of some variables.
class NamedNumbers {
public:
    /// What is added from here to the next leave() is a member, or a variable, of that name.
    void enter(const char* name);
    void leave();
    void add(double number);
    void add(double x, double y, double z);
    std::vector<Named> all() && { return std::move(all_); }

private:
    std::string name() const;

    std::vector<const char*> entered_;
    std::vector<Named> all_;
};

template <class T>
void add_numbers(NamedNumbers& to, const T& value);

template <class T>
void add_member(NamedNumbers& to, const char* name, const T& value) {
    to.enter(name);
    add_numbers(to, value);
    to.leave();
}

/// Adds a value's numbers, member by member; nothing for what has none that we know of.
template <class T>
void add_numbers(NamedNumbers& to, const T& value) {
    if constexpr (std::is_arithmetic_v<T> || std::is_enum_v<T>) {
        to.add(static_cast<double>(value));
    } else if constexpr (requires {
                             { value.x } -> std::convertible_to<long double>;
                             { value.y } -> std::convertible_to<long double>;
                             { value.z } -> std::convertible_to<long double>;
                         }) {
        to.add(static_cast<double>(value.x), static_cast<double>(value.y), static_cast<double>(value.z));
    } else if constexpr (requires { value.has_value(); }) {
        if (value.has_value()) add_numbers(to, *value);
    } else {
        if constexpr (requires { value.P, value.D; }) add_member(to, "P", value.P), add_member(to, "D", value.D);
        if constexpr (requires { value.A, value.B, value.C; })
            add_member(to, "A", value.A), add_member(to, "B", value.B), add_member(to, "C", value.C);
        if constexpr (requires { value.r; }) add_member(to, "C", value.C), add_member(to, "r", value.r);
        if constexpr (requires { value.a, value.b, value.c; })
            add_member(to, "a", value.a), add_member(to, "b", value.b), add_member(to, "c", value.c);
        if constexpr (requires { value.met, value.t; }) add_member(to, "met", value.met), add_member(to, "t", value.t);
        if constexpr (requires { value.real; }) add_member(to, "real", value.real);
        if constexpr (requires { value.t0, value.t1; }) add_member(to, "t0", value.t0), add_member(to, "t1", value.t1);
        if constexpr (requires { value.surface, value.t; })
            add_member(to, "surface", value.surface), add_member(to, "t", value.t);
        if constexpr (requires { value.enters, value.leaves; })
            add_member(to, "enters", value.enters), add_member(to, "leaves", value.leaves);
        if constexpr (requires { value.l, value.intensity; })
            add_member(to, "l", value.l), add_member(to, "intensity", value.intensity);
    }
}

/// A variable of a test, to be looked at when a check is made.
struct SeenVariable {
    const char* name;
    const void* at;
    void (*add)(NamedNumbers& to, const void* at);
};

template <class T>
void add_numbers_at(NamedNumbers& to, const void* at) {
    add_numbers(to, *static_cast<const T*>(at));
}

template <class T>
SeenVariable variable(const char* name, const T& value) {
    return {name, &value, add_numbers_at<T>};
}

/// The variables of the check that is being made. Lives as long as that.
class Seen {
public:
    Seen(int line, std::initializer_list<SeenVariable> variables);
    Seen(const Seen&) = delete;
    Seen& operator=(const Seen&) = delete;
    ~Seen();

    /// The one that was made last and still lives; null if there is none.
    static const Seen* now();

    int line() const { return line_; }
    std::vector<Named> named() const;

private:
    int line_;
    const Seen* before_;
    std::array<SeenVariable, 8> variables_{};
    std::size_t count_ = 0;
};

}  // namespace glassbox::test
