#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#if __has_include(<toml++/toml.hpp>)
#include <toml++/toml.hpp>
#else
#include <toml++/toml.h>
#endif

#include <rgb.hpp>
#include <vec3.hpp>

#include "scene/error.hpp"

// Checked reading of TOML. Each function returns what it is named for, or throws Error with the value's line and
// column, which says what the value is and what it must be.

namespace glassbox {

/// Parses a TOML file. Throws Error at the place that is not TOML, or not UTF-8; `what` is what the file should be: "a
/// scene".
toml::table parse_toml(std::string_view text, const std::string& file, std::string_view what);

/// A value in a TOML file, with its name for error messages: "radius", "center's x".
struct Value {
    const toml::node* node;
    std::string name;
    std::string_view file;
};

Place place(const Value& value);

/// The error "<name> <complaint>" at the value's place.
Error wrong(const Value& value, const std::string& complaint);

std::string text(const Value& value);

/// A finite number, whole or not.
double number(const Value& value);
double number_from_0(const Value& value);
double number_above_0(const Value& value);
int whole_number(const Value& value, int least, int most);

/// The members of an array that must have exactly one per name. `form` says what is expected.
std::vector<Value> members(const Value& value, const std::vector<std::string>& names, std::string_view form);

/// [x, y, z], each a finite number.
Vec3<double> vector(const Value& value);

/// [x, y, z] with a direction that can be computed: not 0, its square neither too large nor too small.
Vec3<double> direction(const Value& value);

/// Checks a computed vector in the same way. Reports an error at `value`, and calls the vector `what`.
void expect_direction(const Vec3<double>& vector, const Value& value, std::string_view what);

/// [red, green, blue], each a whole number from 0 to 255.
Rgb color(const Value& value);

/// A section of a TOML file, [image] or one of [[sphere]]; empty if the file leaves it out.
class Section {
public:
    Section(const toml::table& table, std::string name, std::string_view file)
        : table_(&table), name_(std::move(name)), file_(file) {}

    /// The section itself as a value, for error messages.
    Value self() const { return {table_, name_, file_}; }

    std::optional<Value> find(std::string_view key) const;

    /// The value of a required key. `example` is a line that would be right.
    Value at(std::string_view key, std::string_view example) const;

    /// The key's value, read by `read`; `otherwise` if the key is left out.
    template <class T, class Read>
    T get(std::string_view key, Read read, T otherwise) const {
        const std::optional<Value> value = find(key);
        return value ? T(read(*value)) : otherwise;
    }

    /// The section [key] of this one.
    Section section(std::string_view key) const;

    /// The sections [[key]] of this one, in file order.
    std::vector<Section> sections(std::string_view key) const;

    /// Throws Error if there is a key that is not among the known ones.
    void expect_keys(const std::vector<std::string_view>& known) const;

    /// Throws Error at the key itself if it is there. `complaint` is the whole message.
    void refuse_key(std::string_view key, const std::string& complaint) const;

private:
    const toml::table* table_;
    std::string name_;
    std::string_view file_;
};

}  // namespace glassbox
