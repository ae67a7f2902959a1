#include "compare/hits_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <string>
#include <string_view>

#include "scene/error.hpp"
#include "scene/number_field.hpp"
#include "scene/suggestion.hpp"
#include "scene/text_file.hpp"

namespace glassbox {

namespace {

/// A column of the table; `none` where the header does not name it.
struct Columns {
    static constexpr std::size_t none = static_cast<std::size_t>(-1);

    std::size_t count = 0;
    std::size_t ray = none, verdict = none, surface = none, t = none;
};

struct Field {
    std::string_view text;
    Place place;
};

/// The fields of a line, without the blanks around them.
std::vector<Field> fields_of(std::string_view line, Place place) {
    std::vector<Field> fields;
    for (std::size_t begin = 0; begin <= line.size();) {
        const std::size_t end = std::min(line.find(',', begin), line.size());
        place.column = begin + 1;
        fields.push_back({trimmed(line.substr(begin, end - begin)), place});
        begin = end + 1;
    }
    return fields;
}

Columns columns_of(std::string_view header, const Place& place) {
    Columns columns;
    const std::vector<Field> fields = fields_of(header, place);
    columns.count = fields.size();
    for (std::size_t i = 0; i < fields.size(); ++i) {
        const auto take = [&](std::string_view name, std::size_t& column) {
            if (fields[i].text != name) return;
            if (column != Columns::none)
                throw error_at(fields[i].place, fmt::format("a second column '{}'; a table has one", name));
            column = i;
        };
        take("ray", columns.ray);
        take("verdict", columns.verdict);
        take("surface", columns.surface);
        take("t", columns.t);
    }
    if (columns.verdict == Columns::none)
        throw error_at(place,
                       "the first line must name the columns, 'verdict' among them, as in ray,verdict,surface,t");
    return columns;
}

Shot::Answer verdict_of(const Field& field) {
    std::string word(field.text);
    std::ranges::transform(word, word.begin(),
                           [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
    if (word == "hit") return Shot::Answer::hit;
    if (word == "miss") return Shot::Answer::miss;
    if (word == "invalid") return Shot::Answer::invalid;
    constexpr std::string_view words[] = {"hit", "miss", "invalid"};
    throw error_at(field.place,
                   fmt::format("{} is no verdict; {}", in_quotes(field.text), suggestion(field.text, words)));
}

/// A number from 0 to count − 1 that counts things of that name.
std::size_t index_in(const Field& field, std::size_t count, std::string_view thing) {
    std::size_t index = 0;
    const auto [end, error] = std::from_chars(field.text.data(), field.text.data() + field.text.size(), index);
    const bool is_read = error == std::errc{} && end == field.text.data() + field.text.size();
    if (is_read && index < count) return index;
    if (count == 0) throw error_at(field.place, fmt::format("{} {}: there is none", thing, in_quotes(field.text)));
    throw error_at(field.place, fmt::format("{} {} is not there; they are counted from 0 to {}", thing,
                                            in_quotes(field.text), count - 1));
}

/// Notes with how many digits a t is written.
void count_digits(std::string_view text, Claims& claims) {
    const std::string_view number = text.substr(0, text.find_first_of("eE"));
    if (number.find_first_not_of("+-.0123456789") != std::string_view::npos) {  // hexadecimal, say: all digits
        claims.digits = 99;
        return;
    }
    const std::size_t first = number.find_first_of("123456789"), point = number.find('.');
    if (first == std::string_view::npos) return;
    const auto digits = static_cast<int>(number.size() - first) - (point != std::string_view::npos && point > first);
    claims.digits = std::max(claims.digits, digits);
    if (point != std::string_view::npos && number.size() == text.size())
        claims.decimals = std::max(claims.decimals, static_cast<int>(number.size() - point) - 1);
}

Claim claim_of(const std::vector<Field>& row, const Columns& columns, std::size_t surfaces, Claims& claims) {
    Claim claim{verdict_of(row[columns.verdict]), {}, {}};
    if (claim.answer != Shot::Answer::hit) return claim;
    if (columns.surface != Columns::none && !row[columns.surface].text.empty())
        claim.surface = index_in(row[columns.surface], surfaces, "surface");
    if (columns.t != Columns::none && !row[columns.t].text.empty()) {
        claim.t = read_number(row[columns.t].text, row[columns.t].place);
        count_digits(row[columns.t].text, claims);
    }
    return claim;
}

}  // namespace

double Claims::half_digit_if_shortened(double t, int digits_of_scalar) const {
    if (!is_shortened(digits_of_scalar) || t == 0 || !std::isfinite(t)) return 0;
    const double of_all = std::pow(10.0, std::floor(std::log10(std::abs(t))) + 1 - digits);
    const double behind_point = decimals > 0 ? std::pow(10.0, -decimals) : 0;
    return std::max(of_all, behind_point) / 2 * (1 + 0x1p-40);
}

Claims read_hits(const std::filesystem::path& file, std::size_t rays, std::size_t surfaces) {
    const std::string content = read_lines(file);
    const std::vector<std::string_view> lines = lines_of(content);
    const Place whole{file.string(), 1, 1};
    const Columns columns = columns_of(lines.empty() ? std::string_view{} : lines.front(), whole);
    Claims claims;
    claims.rays.resize(rays);
    std::vector<bool> told(rays);
    std::size_t rows = 0;
    for (std::size_t i = 1; i < lines.size(); ++i) {
        if (trimmed(lines[i]).empty()) continue;
        const std::vector<Field> row = fields_of(lines[i], {file.string(), i + 1, 1});
        if (row.size() != columns.count)
            throw error_at(
                row[std::min(row.size() - 1, columns.count)].place,
                fmt::format("{} in this row; the header names {}", counted(row.size(), "field"), columns.count));
        if (columns.ray == Columns::none && rows == rays)
            throw error_at(row.front().place,
                           fmt::format("a row more than there are rays, {}; a row each, in their order", rays));
        const std::size_t ray = columns.ray == Columns::none ? rows : index_in(row[columns.ray], rays, "ray");
        ++rows;
        if (told[ray])
            throw error_at(row[columns.ray].place, fmt::format("ray {} is there twice; tell of each ray once", ray));
        told[ray] = true;
        claims.rays[ray] = claim_of(row, columns, surfaces, claims);
    }
    if (const auto missing = std::ranges::find(told, false); missing != told.end())
        throw error_at({file.string(), lines.size() + 1, 1},
                       fmt::format("ray {} is missing: there {}, and {} here", missing - told.begin(),
                                   rays == 1 ? "is 1 ray" : fmt::format("are {} rays", rays), counted(rows, "row")));
    return claims;
}

}  // namespace glassbox
