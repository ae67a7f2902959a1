#pragma once
#include <array>
#include <optional>
#include <string_view>
#include <vector>

namespace glassbox {

/// A value that is chosen by its name, in a scene file, on the command line or from a list.
template <class Value>
struct Named {
    std::string_view name;
    Value value;
    std::string_view help;  ///< what it is, in at most 60 characters
};

template <class Value, std::size_t count>
using NameTable = std::array<Named<Value>, count>;

template <class Value, std::size_t count>
std::vector<std::string_view> names(const NameTable<Value, count>& table) {
    std::vector<std::string_view> all;
    for (const Named<Value>& entry : table) all.push_back(entry.name);
    return all;
}

/// The value of that name, if there is one.
template <class Value, std::size_t count>
constexpr std::optional<Value> find_named(const NameTable<Value, count>& table, std::string_view name) {
    for (const Named<Value>& entry : table)
        if (entry.name == name) return entry.value;
    return {};
}

/// The name of the first value that `is_it` accepts; "" if there is none.
template <class Value, std::size_t count, class IsIt>
constexpr std::string_view name_where(const NameTable<Value, count>& table, const IsIt& is_it) {
    for (const Named<Value>& entry : table)
        if (is_it(entry.value)) return entry.name;
    return {};
}

}  // namespace glassbox
