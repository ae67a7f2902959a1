#pragma once
#include <string>
#include <string_view>

#include "explain/story.hpp"

namespace glassbox {

// What a pixel shows beside what is true, in words. All ways of showing a story use these.

/// "✓", "✗", or "?" where it is not known.
std::string_view sign(story::Mark mark);

/// "right", "wrong hit", "wrong miss", "wrong surface".
std::string_view word(Verdict verdict);

/// Whether the pixel shows what is true. Unknown in stage 1, and for a ray that is not valid.
story::Mark mark_of(const Story& story);

/// Whether it is proven that the pixel shows what is true.
bool is_surely_right(const Story& story);

/// What is shown, what is true, and how sure that is, in a line: "right, proven, 12.2 digits to spare: surface 816 is
/// shown, and nearest"; "wrong hit, proven by error bounds: surface 55 is shown, and nothing is there".
std::string verdict_line(const Story& story);

/// Its beginning, for where there is little room: "right, proven, 12.2 digits to spare"; "wrong hit, proven by error
/// bounds: surface 55 is shown, and nothing is there".
std::string short_verdict_line(const Story& story);

/// Whether a surface is met, or missed, as it truly is.
story::Mark mark_of(const story::Surface& surface, const Story& story);

/// "right: truly met, nearest"; "wrong: truly missed".
std::string truth_of(const story::Surface& surface, const Story& story);

/// Whether the sign that was computed is the true one.
story::Mark mark_of_sign(const story::Number& number);

/// log10 of |s| over its bound, rounded down to a tenth: 0 or more where the sign is proven, and how many digits it has
/// to spare; infinite where nothing was rounded, or where nothing is known.
double margin(const story::LeastSure& least);

/// "12.2"; "−0.7"; "∞", "−∞".
std::string margin_text(const story::LeastSure& least);

/// Whether bounds leave that sign open, but exact arithmetic has decided it.
bool is_decided_exactly(const story::LeastSure& least, const Options& options);

/// "12.2 digits to spare"; "−0.7 digits, undecided"; "−0.7 digits by bounds alone, decided in exact arithmetic".
std::string margin_in_words(const story::LeastSure& least, const Options& options);

/// The number whose sign is the least sure: "c of surface 816"; "t of surfaces 3 and 816".
std::string whose(const story::LeastSure& least);

/// The same beside the verdict's line, which may name several numbers: "c of surface 55, the least sure of b and c".
std::string whose(const story::LeastSure& least, const Story& story);

/// What joins it to that line: ", the least sure of b and c"; empty where the line names no more.
std::string among_turned(const story::LeastSure& least, const Story& story);

/// Which operation lost its bits: "0.511977 + −0.498313 lost 6.1 bits"; "no bits lost".
std::string lost_by(const story::LeastSure& least, const Story& story);

/// How the search went: "1255 tested, 3 met"; "14 of 1255 tested, 3 met".
std::string counts(const Story& story);

/// "9 nodes, 41 of their boxes missed"; empty without the engine.
std::string boxes(const Story& story);

}  // namespace glassbox
