#include "viewer/model/story/sources.hpp"

#include <algorithm>

#include "explain/words.hpp"
#include "output/embed.hpp"
#include "scene/text_file.hpp"

// Written by CMake: a GLASSBOX_EMBED for each header of the core, and the table of them.
#include "core_sources.inc"

namespace glassbox {

namespace {

bool describes(std::string_view line) {
    const std::string_view text = trimmed(line);
    return text.starts_with("///") && !text.starts_with("///<");
}

bool is_name(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_'; }

/// Returns the name that a declaration declares: Stable for "struct Stable {", side for "constexpr Real side(const …".
std::string declared_name(std::string_view line) {
    for (const std::string_view word : {"struct ", "enum class "})
        if (const std::size_t at = line.find(word); at != std::string_view::npos) {
            line = line.substr(at + word.size());
            return std::string(line.substr(0, line.find_first_of(" :{")));
        }
    const std::size_t end = line.find('(');
    if (end == std::string_view::npos) return {};
    if (const std::size_t at = line.find("operator"); at < end) return std::string(line.substr(at, end - at));
    std::size_t begin = end;
    while (begin > 0 && is_name(line[begin - 1])) --begin;
    return std::string(line.substr(begin, end - begin));
}

std::span<const SourceFile> own_sources(const Story& story) {
    return story.own ? story.own->files() : std::span<const SourceFile>();
}

}  // namespace

std::span<const SourceFile> core_sources() { return embedded_core_sources; }

const SourceFile* find_source(std::string_view path) {
    const auto found = std::find_if(std::begin(embedded_core_sources), std::end(embedded_core_sources),
                                    [&](const SourceFile& file) { return file.path == path; });
    return found == std::end(embedded_core_sources) ? nullptr : &*found;
}

const SourceFile* find_source(const Story& story, std::string_view file) {
    for (const SourceFile& own : own_sources(story))
        if (own.path == file) return &own;
    return find_source(source(file));
}

bool is_own(const Story& story, const SourceFile& file) {
    return std::ranges::any_of(own_sources(story), [&](const SourceFile& own) { return &own == &file; });
}

const SourceFile* find_header(const Story& story, std::string_view name) {
    for (const std::span<const SourceFile> files : {own_sources(story), core_sources()})
        for (const SourceFile& file : files)
            if (file.path.ends_with(name) && file.path.substr(0, file.path.size() - name.size()).ends_with('/'))
                return &file;
    return nullptr;
}

std::vector<std::string_view> lines(const SourceFile& file) { return lines_of(file.text); }

Described described_at(const SourceFile& file, std::size_t line) {
    const std::vector<std::string_view> all = lines(file);
    std::size_t last = std::min(line, all.size());
    while (last > 0 && !describes(all[last - 1])) --last;
    if (last == 0) return {};
    std::size_t first = last;
    while (first > 1 && describes(all[first - 2])) --first;

    Described found{.name = {}, .file = &file, .line = first, .text = {}};
    for (std::size_t i = first; i <= last; ++i) {
        const std::string_view text = trimmed(trimmed(all[i - 1]).substr(3));
        if (text.empty()) {
            found.text += "\n\n";
            continue;
        }
        if (!found.text.empty() && found.text.back() != '\n') found.text += ' ';
        found.text += text;
    }
    for (std::size_t i = last; i < all.size() && found.name.empty(); ++i)
        if (!trimmed(all[i]).starts_with("template") && !trimmed(all[i]).starts_with("requires"))
            found.name = declared_name(all[i]);
    return found;
}

Described described_function(const Story& story, std::string_view file_name, std::string_view function) {
    for (const std::span<const SourceFile> files : {own_sources(story), core_sources()})
        for (const SourceFile& file : files) {
            if (!file.path.ends_with(file_name)) continue;
            const std::vector<std::string_view> all = lines(file);
            for (std::size_t i = 0; i < all.size(); ++i)
                if (declared_name(all[i]) == function && !trimmed(all[i]).starts_with("return"))
                    return described_at(file, i + 1);
        }
    return {};
}

}  // namespace glassbox
