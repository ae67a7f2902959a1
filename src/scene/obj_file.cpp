#include "scene/obj_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <string>
#include <string_view>

#include "scene/error.hpp"
#include "scene/polygon.hpp"
#include "scene/text_file.hpp"

// Why not tinyobjloader: it rounds twice (it reads 0.3 as 0.30000000000000004) and its errors give no place. This
// reader makes every coordinate the double nearest to the file's number.

namespace glassbox {
namespace {

/// A word of a text, with its offset.
struct Word {
    std::string_view text;
    std::size_t offset;
};

/// Reads a text line by line and word by word. A backslash at the end of a line joins it with the next.
class Words {
public:
    explicit Words(std::string_view text) : text_(text) {}

    /// The next word of this line; empty at its end and where a comment starts.
    Word next() {
        while (at_ < text_.size() && blank() > 0) at_ += blank();
        const std::size_t start = at_;
        if (at_ < text_.size() && text_[at_] == '#') return {{}, start};
        while (at_ < text_.size() && text_[at_] != '\n' && blank() == 0) ++at_;
        return {text_.substr(start, at_ - start), start};
    }

    /// Goes to the next line; false if there is none.
    bool next_line() {
        while (!next().text.empty()) continue;
        const std::size_t end = text_.find('\n', at_);
        if (end == std::string_view::npos) return false;
        at_ = end + 1;
        return true;
    }

private:
    /// How many characters the blank here takes: a space, a tab, a carriage return, or a joint of two lines.
    std::size_t blank() const {
        const char c = text_[at_];
        if (c == ' ' || c == '\t' || c == '\r') return 1;
        if (c != '\\') return 0;
        const std::string_view rest = text_.substr(at_ + 1, 2);
        return rest.starts_with('\n') ? 2 : rest == "\r\n" ? 3 : 0;
    }

    std::string_view text_;
    std::size_t at_ = 0;
};

struct Source {
    std::string file;
    std::string_view text;
};

/// The error at an offset of the text. Counts lines only now, when they are needed.
Error error_in(const Source& source, std::size_t offset, const std::string& message) {
    const std::string_view before = source.text.substr(0, offset);
    const auto line = static_cast<std::size_t>(std::count(before.begin(), before.end(), '\n')) + 1;
    const std::size_t line_start = before.rfind('\n') + 1;  // npos + 1 = 0 on the first line
    return error_at({source.file, line, offset - line_start + 1}, message);
}

double coordinate(const Source& source, const Word& word) {
    std::string_view digits = word.text;
    if (digits.starts_with('+') && !digits.starts_with("+-")) digits.remove_prefix(1);
    const char* const end = digits.data() + digits.size();
    double value = 0;
    const auto [stopped, error] = std::from_chars(digits.data(), end, value);
    if (stopped != end || error == std::errc::invalid_argument)
        throw error_in(source, word.offset, fmt::format("{} is not a number", in_quotes(word.text)));
    if (error == std::errc::result_out_of_range) value = std::strtod(std::string(digits).c_str(), nullptr);
    if (!std::isfinite(value))
        throw error_in(source, word.offset, fmt::format("{} is not a finite number", in_quotes(word.text)));
    return value;
}

Vec3<double> vertex(const Source& source, Words& words) {
    double xyz[3];
    for (int k = 0; k < 3; ++k) {
        const Word word = words.next();
        if (word.text.empty())
            throw error_in(source, word.offset,
                           fmt::format("a vertex must have three numbers, v x y z; this one has {}", k));
        xyz[k] = coordinate(source, word);
    }
    return {xyz[0], xyz[1], xyz[2]};
}

/// Whether it is a face; before version 3 of the format its name was fo.
bool is_face(const Word& keyword) { return keyword.text == "f" || keyword.text == "fo"; }

/// Throws Error for a statement with surfaces that cannot be read here: they must not be dropped silently.
void refuse_lost(const Source& source, const Word& keyword) {
    constexpr std::array<std::string_view, 6> free_forms{"surf", "bzp", "bsp", "cdc", "cdp", "res"};
    constexpr std::array<std::string_view, 2> from_elsewhere{"call", "csh"};
    constexpr std::array<std::string_view, 3> large{"V", "F", "FO"};
    const auto is_one_of = [&](const auto& names) {
        return std::find(names.begin(), names.end(), keyword.text) != names.end();
    };
    if (is_one_of(free_forms))
        throw error_in(
            source, keyword.offset,
            fmt::format("{} is a free-form surface; a mesh must be made of flat faces, f: let the program that "
                        "wrote the file cut it into polygons",
                        in_quotes(keyword.text)));
    if (is_one_of(from_elsewhere))
        throw error_in(source, keyword.offset,
                       fmt::format("{} takes surfaces from elsewhere; all of a mesh must be in its file",
                                   in_quotes(keyword.text)));
    if (is_one_of(large))
        throw error_in(
            source, keyword.offset,
            fmt::format("{} must be written in small letters: v for a vertex, f for a face", in_quotes(keyword.text)));
}

std::vector<Vec3<double>> read_vertices(const Source& source) {
    std::vector<Vec3<double>> vertices;
    Words words(source.text);
    do {
        const Word keyword = words.next();
        refuse_lost(source, keyword);
        if (keyword.text != "v") continue;
        if (vertices.size() == std::numeric_limits<std::uint32_t>::max())
            throw error_in(source, keyword.offset, "there are too many vertices; at most 4294967295 can be numbered");
        vertices.push_back(vertex(source, words));
    } while (words.next_line());
    return vertices;
}

std::string counted(std::size_t vertices) {
    return fmt::format("{} {}", vertices, vertices == 1 ? "vertex" : "vertices");
}

/// The index, from 0, of the vertex that a corner names: by number from 1, or counting back from −1, the one before the
/// face. "7", "7/1", "7//3" and "7/1/3" all name vertex 7.
std::uint32_t corner(const Source& source, const Word& word, std::size_t vertices, std::size_t vertices_before) {
    long long number = 0;
    const char* const end = word.text.data() + word.text.size();
    const auto [stopped, error] = std::from_chars(word.text.data(), end, number);
    if ((stopped != end && *stopped != '/') || error == std::errc::invalid_argument)
        throw error_in(
            source, word.offset,
            fmt::format("{} is not a face's corner; it must be a vertex's number, like 7, 7/1, 7//3 or 7/1/3",
                        in_quotes(word.text)));
    const std::string_view name(word.text.data(), static_cast<std::size_t>(stopped - word.text.data()));
    const bool fits = error == std::errc();
    if (fits && number == 0) throw error_in(source, word.offset, "there is no vertex 0; vertices are numbered from 1");
    if (name.starts_with('-')) {
        if (!fits || static_cast<unsigned long long>(-(number + 1)) >= vertices_before)
            throw error_in(source, word.offset,
                           fmt::format("there is no vertex {}: only {} come{} before this face", name,
                                       counted(vertices_before), vertices_before == 1 ? "s" : ""));
        return static_cast<std::uint32_t>(static_cast<long long>(vertices_before) + number);
    }
    if (!fits || static_cast<unsigned long long>(number) > vertices)
        throw error_in(source, word.offset,
                       fmt::format("there is no vertex {}: the file has {}", name, counted(vertices)));
    return static_cast<std::uint32_t>(number - 1);
}

std::vector<std::array<std::uint32_t, 3>> read_faces(const Source& source, const std::vector<Vec3<double>>& vertices) {
    std::vector<std::array<std::uint32_t, 3>> faces;
    std::vector<std::uint32_t> corners;
    std::vector<Vec3<double>> polygon;
    std::size_t vertices_before = 0;
    Words words(source.text);
    do {
        const Word keyword = words.next();
        if (keyword.text == "v") ++vertices_before;
        if (!is_face(keyword)) continue;
        corners.clear();
        for (Word word = words.next(); !word.text.empty(); word = words.next())
            corners.push_back(corner(source, word, vertices.size(), vertices_before));
        if (corners.size() < 3)
            throw error_in(source, keyword.offset,
                           fmt::format("a face must have at least three corners; this one has {}", corners.size()));
        if (corners.size() == 3) {
            faces.push_back({corners[0], corners[1], corners[2]});
            continue;
        }
        polygon.clear();
        for (const auto index : corners) polygon.push_back(vertices[index]);
        for (const auto& [a, b, c] : triangulate(polygon)) faces.push_back({corners[a], corners[b], corners[c]});
    } while (words.next_line());
    return faces;
}

bool has_faces(std::string_view text) {
    Words words(text);
    do
        if (is_face(words.next())) return true;
    while (words.next_line());
    return false;
}

}  // namespace

Mesh read_obj(const std::filesystem::path& file, const Rgb& color) {
    const std::string text = read_lines(file);
    const Source source{file.string(), text};
    // Vertices first: a face may name one that comes after it.
    std::vector<Vec3<double>> vertices = read_vertices(source);
    std::vector<std::array<std::uint32_t, 3>> faces = read_faces(source, vertices);
    if (faces.empty() && has_faces(text))
        throw error_at({source.file}, "no face has an area; there must be one whose corners do not all lie on a line");
    if (faces.empty()) throw error_at({source.file}, "there are no faces; an OBJ file must have lines like f 1 2 3");
    return {std::move(vertices), std::move(faces), color, file.string()};
}

}  // namespace glassbox
