#include "scene/toml_value.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "scene/direction.hpp"
#include "scene/suggestion.hpp"
#include "scene/text_file.hpp"
#include "scene/toml_depth.hpp"

namespace glassbox {
namespace {

Place place(const toml::source_region& region, std::string_view file) {
    return {std::string(file), region.begin.line, region.begin.column};
}

/// "a string", "an array", … as in "radius must be a number, not a string".
std::string_view kind(const toml::node& node) {
    switch (node.type()) {
        case toml::node_type::string:
            return "a string";
        case toml::node_type::integer:
        case toml::node_type::floating_point:
            return "a number";
        case toml::node_type::boolean:
            return "true or false";
        case toml::node_type::array:
            return node.is_array_of_tables() ? "a list of tables" : "an array";
        case toml::node_type::table:
            return "a table";
        default:
            return "a date or time";
    }
}

/// A number nearly as the file writes it: 500.0 is not 500.
std::string shown(const Value& value) {
    if (value.node->is_integer()) return fmt::format("{}", value.node->as_integer()->get());
    return fmt::format("{:#}", value.node->as_floating_point()->get());
}

/// The line of that number, from 1.
std::string_view line_of(std::string_view text, std::size_t number) {
    for (; number > 1; --number) text.remove_prefix(std::min(text.find('\n'), text.size() - 1) + 1);
    return text.substr(0, text.find('\n'));
}

/// How many bytes the first `columns` characters of a UTF-8 line take.
std::size_t bytes_of(std::string_view line, std::size_t columns) {
    std::size_t bytes = 0;
    const auto continues = [&] {
        return bytes < line.size() && (static_cast<unsigned char>(line[bytes]) & 0xC0u) == 0x80u;
    };
    for (; columns > 0 && bytes < line.size(); --columns) do
            ++bytes;
        while (continues());
    return bytes;
}

/// Rewords toml++'s error about a number that it cannot hold, and places it at the number; nothing if the error is
/// about something else. `line` is the line of the number.
std::optional<Error> number_error(const Place& stopped, std::string_view line, std::string_view description) {
    const auto says = [&](std::string_view words) { return description.find(words) != std::string_view::npos; };
    const bool is_whole = says("is not representable in 64 bits");
    const bool is_large = says("floating-point") && says("could not be interpreted");
    if (!is_whole && !is_large) {
        if (!says("numeric value too long") && !says("exceeds length limit")) return {};
        return error_at(stopped, "this number has too many digits; a double has 17: write it shorter, like 1.25e-30");
    }
    // The parser stopped after the number.
    const std::string_view before = line.substr(0, bytes_of(line, stopped.column - 1));
    const std::size_t start = before.find_last_not_of("0123456789abcdefABCDEFxo_.+-") + 1;
    const std::string_view digits = before.substr(start);
    const Place place{stopped.file, stopped.line, stopped.column - digits.size()};
    std::string plain(digits);
    std::erase(plain, '_');
    if (is_large && !std::isinf(std::strtod(plain.c_str(), nullptr))) return {};
    if (is_large)
        return error_at(place, fmt::format("{} is too large; a number must lie between -1.7976931348623157e308 and "
                                           "1.7976931348623157e308",
                                           in_quotes(digits)));
    return error_at(place,
                    fmt::format("{} is too large for a whole number, which must lie between -9223372036854775808 "
                                "and 9223372036854775807; others have a point or an exponent, like 1e20",
                                in_quotes(digits)));
}

std::string_view plural(std::size_t count) { return count == 1 ? "" : "s"; }

}  // namespace

toml::table parse_toml(std::string_view text, const std::string& file, std::string_view what) {
    const auto place_of = [&](std::size_t offset) -> Place {
        const std::string_view before = text.substr(0, offset);
        const auto line = static_cast<std::size_t>(std::count(before.begin(), before.end(), '\n')) + 1;
        const std::size_t line_start = before.rfind('\n') + 1;  // npos + 1 = 0 on the first line
        return {file, line, offset - line_start + 1};
    };
    if (const auto offset = first_not_utf8(text))
        throw error_at(place_of(*offset), fmt::format("this is not UTF-8; {} must be a text file in UTF-8", what));
    if (const auto offset = first_too_deep(text))
        throw error_at(place_of(*offset),
                       fmt::format("tables and arrays are nested more than {0} levels deep here; {1} has a few, and "
                                   "dotted keys and brackets must make {0} at most",
                                   most_toml_levels, what));
    try {
        return toml::parse(text, file);
    } catch (const toml::parse_error& error) {
        const auto where = error.source().begin;
        std::string_view description = error.description();
        if (const auto about_number =
                number_error({file, where.line, where.column}, line_of(text, where.line), description))
            throw *about_number;
        if (description.starts_with("Error ")) description.remove_prefix(6);
        std::string message(description);
        std::replace(message.begin(), message.end(), '\n', ' ');
        throw error_at({file, where.line, where.column}, "this is not TOML: " + message);
    }
}

Place place(const Value& value) { return place(value.node->source(), value.file); }

Error wrong(const Value& value, const std::string& complaint) {
    return error_at(place(value), value.name + " " + complaint);
}

std::string text(const Value& value) {
    if (const auto* string = value.node->as_string()) return string->get();
    throw wrong(value, fmt::format("must be a string, in quotes, not {}", kind(*value.node)));
}

double number(const Value& value) {
    if (const auto* integer = value.node->as_integer()) return static_cast<double>(integer->get());
    const auto* floating = value.node->as_floating_point();
    if (!floating) throw wrong(value, fmt::format("must be a number, not {}", kind(*value.node)));
    if (!std::isfinite(floating->get()))
        throw wrong(value, fmt::format("is {}; it must be a finite number", floating->get()));
    return floating->get();
}

double number_from_0(const Value& value) {
    const double x = number(value);
    if (x < 0) throw wrong(value, fmt::format("is {}; it must be 0 or more", x));
    return x;
}

double number_above_0(const Value& value) {
    const double x = number(value);
    if (!(x > 0)) throw wrong(value, fmt::format("is {}; it must be greater than 0", x));
    return x;
}

int whole_number(const Value& value, int least, int most) {
    if (!value.node->is_number())
        throw wrong(value, fmt::format("must be a whole number from {} to {}, not {}", least, most, kind(*value.node)));
    const auto* integer = value.node->as_integer();
    if (!integer || integer->get() < least || integer->get() > most)
        throw wrong(value, fmt::format("is {}; it must be a whole number from {} to {}", shown(value), least, most));
    return static_cast<int>(integer->get());
}

std::vector<Value> members(const Value& value, const std::vector<std::string>& names, std::string_view form) {
    const toml::array* array = value.node->as_array();
    if (!array) throw wrong(value, fmt::format("must be {}, not {}", form, kind(*value.node)));
    if (array->size() != names.size())
        throw wrong(value, fmt::format("has {} member{}; it must be {}", array->size(), plural(array->size()), form));
    std::vector<Value> found;
    for (std::size_t k = 0; k < names.size(); ++k) found.push_back({array->get(k), names[k], value.file});
    return found;
}

Vec3<double> vector(const Value& value) {
    const auto xyz =
        members(value, {value.name + "'s x", value.name + "'s y", value.name + "'s z"}, "three numbers, [x, y, z]");
    return {number(xyz[0]), number(xyz[1]), number(xyz[2])};
}

Vec3<double> direction(const Value& value) {
    const Vec3<double> v = vector(value);
    expect_direction(v, value, value.name);
    return v;
}

void expect_direction(const Vec3<double>& v, const Value& value, std::string_view what) {
    if (const std::string why = why_no_direction(v); !why.empty())
        throw error_at(place(value), fmt::format("{} {}", what, why));
}

Rgb color(const Value& value) {
    constexpr std::string_view form = "three whole numbers from 0 to 255, [red, green, blue]";
    const auto rgb = members(value, {value.name + "'s red", value.name + "'s green", value.name + "'s blue"}, form);
    const auto byte = [](const Value& channel) {
        const auto* floating = channel.node->as_floating_point();
        if (floating && floating->get() >= 0 && floating->get() <= 1)
            throw wrong(channel, fmt::format("is {}; colours are whole numbers from 0 to 255: write {}", shown(channel),
                                             std::lround(floating->get() * 255)));
        return static_cast<std::uint8_t>(whole_number(channel, 0, 255));
    };
    return {byte(rgb[0]), byte(rgb[1]), byte(rgb[2])};
}

std::optional<Value> Section::find(std::string_view key) const {
    const toml::node* node = table_->get(key);
    if (!node) return std::nullopt;
    return Value{node, std::string(key), file_};
}

Value Section::at(std::string_view key, std::string_view example) const {
    if (auto value = find(key)) return *std::move(value);
    throw wrong(self(), fmt::format("has no {}; it needs one, like {}", key, example));
}

Section Section::section(std::string_view key) const {
    static const toml::table left_out;
    const auto value = find(key);
    if (!value) return {left_out, fmt::format("[{}]", key), file_};
    const toml::table* table = value->node->as_table();
    if (!table && value->node->is_array_of_tables())
        throw wrong(*value, fmt::format("must be one section, [{0}]; it is written [[{0}]] here", key));
    if (!table) throw wrong(*value, fmt::format("must be a section, [{}], not {}", key, kind(*value->node)));
    return {*table, fmt::format("[{}]", key), file_};
}

std::vector<Section> Section::sections(std::string_view key) const {
    const auto value = find(key);
    if (!value) return {};
    if (value->node->is_table())
        throw wrong(*value, fmt::format("must be written [[{0}]], once for each {0}; it is written [{0}] here", key));
    const toml::array* array = value->node->as_array();
    if (!array)
        throw wrong(*value,
                    fmt::format("must be sections, [[{0}]], one for each {0}, not {1}", key, kind(*value->node)));
    std::vector<Section> found;
    for (const toml::node& node : *array) {
        if (!node.is_table())
            throw wrong({&node, std::string(key), file_},
                        fmt::format("must be sections, [[{0}]], one for each {0}, not {1}", key, kind(node)));
        found.emplace_back(*node.as_table(), fmt::format("[[{}]]", key), file_);
    }
    return found;
}

void Section::expect_keys(const std::vector<std::string_view>& known) const {
    // The table is sorted by name; of several unknown keys, reports the first in the file.
    const auto is_known = [&](const toml::key& key) {
        return std::find(known.begin(), known.end(), key.str()) != known.end();
    };
    const toml::key* unknown = nullptr;
    const toml::node* its_value = nullptr;
    for (const auto& [key, node] : *table_) {
        const auto begin = key.source().begin;
        if (is_known(key) || (unknown && !(begin < unknown->source().begin))) continue;
        unknown = &key;
        its_value = &node;
    }
    if (!unknown) return;
    const std::string_view what = its_value->is_table() || its_value->is_array_of_tables() ? "section" : "key";
    throw error_at(place(unknown->source(), file_),
                   fmt::format("unknown {} {} in {}; {}", what, in_quotes(unknown->str()), name_,
                               suggestion(unknown->str(), known)));
}

void Section::refuse_key(std::string_view key, const std::string& complaint) const {
    const auto found = table_->find(key);
    if (found != table_->end()) throw error_at(place(found->first.source(), file_), complaint);
}

}  // namespace glassbox
