#pragma once
#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "explain/story.hpp"

namespace glassbox {

/// The headers of the core as they were when the program was built, because an installed program has no sources beside
/// it.
std::span<const SourceFile> core_sources();

/// Returns the header with this path; null if the core has none.
const SourceFile* find_source(std::string_view path);

/// Returns the header that a step or a call of the story names: of those whose formulas it tells, else of ours. Null if
/// there is none. It is there as long as the story is.
const SourceFile* find_source(const Story& story, std::string_view file);

/// Whether a header that was found is one of the story's own, and not one of ours.
bool is_own(const Story& story, const SourceFile& file);

/// Returns the header of that name, "vec3.hpp", in the same way.
const SourceFile* find_header(const Story& story, std::string_view name);

/// Returns its lines, without line ends; the first one is line 1 of a compiler's message.
std::vector<std::string_view> lines(const SourceFile& file);

/// What a header says about a function: the lines that begin with `///` above it.
struct Described {
    std::string name;  ///< "side"
    const SourceFile* file = nullptr;
    std::size_t line = 0;  ///< where it says so, from 1
    std::string text;      ///< lines joined; an empty line between paragraphs
};

/// Returns the nearest description above a line (from 1), or on it; without text if there is none.
Described described_at(const SourceFile& file, std::size_t line);

/// Returns the description of a function by its name, in the file whose path ends with `file_name`: one of the story's
/// own, else of ours.
Described described_function(const Story& story, std::string_view file_name, std::string_view function);

}  // namespace glassbox
