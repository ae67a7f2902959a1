#pragma once
#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "explain/phrases.hpp"
#include "explain/story.hpp"
#include "viewer/model/state/number_form.hpp"

namespace glassbox {

/// A number that the inspector shows, and its place in the output of `glassbox explain --json`.
struct InspectedNumber {
    std::string path;                      ///< JSON pointer: of the number, or of the object of a checked one
    double value = 0;                      ///< of a checked number: its value
    std::optional<story::Number> checked;  ///< with its bound, its truth and its lost bits
    bool is_count = false;                 ///< a whole number that nothing rounds: written as such in every form
};

/// A row: a name, numbers and words. A vector or a colour has three numbers.
struct InspectorRow {
    std::string label;  ///< no two rows of a part have the same
    std::vector<InspectedNumber> numbers;
    std::string note;
    std::optional<story::Mark> mark = {};  ///< whether what was computed is true
    std::optional<Rgb> color = {};         ///< what the numbers are
    bool with_bar = false;                 ///< drawn with its error bar
};

/// What is drawn above a part's rows.
enum class Diagram {
    none,
    sphere,    ///< the line through the circle
    triangle,  ///< the triangle as seen along the ray
    weights,   ///< the three weights, which add up to 1
    angles,    ///< the dot products
    terms,     ///< the shading's terms, which add up to the pixel
    bits,      ///< of the number that lost the most
};

/// A part of the inspector with a heading, which can be collapsed.
struct InspectorPart {
    std::string title;                            ///< no two parts at one place have the same
    std::string note;                             ///< beside the title, in words
    std::optional<story::Mark> mark = {};         ///< whether what was computed is true
    std::optional<InspectedNumber> number = {};   ///< that the title names
    std::optional<InspectedNumber> in_note = {};  ///< that the note names, briefly
    std::optional<Rgb> color = {};
    bool open = true;  ///< at first
    Diagram drawing = Diagram::none;
    std::optional<std::size_t> surface = {};  ///< which of story.surfaces is drawn
    std::vector<InspectorRow> rows = {};
    std::vector<InspectorPart> parts = {};
};

/// All that the inspector shows, in the order of `glassbox explain`.
std::vector<InspectorPart> inspector(const Story& story);

/// The parts of both pinned pixels' stories, kept between frames for as long as they are shown.
class InspectorParts {
public:
    void update(const std::shared_ptr<const Story>& first, const std::shared_ptr<const Story>& second) {
        first_.update(first);
        second_.update(second);
    }
    const std::vector<InspectorPart>& first() const { return first_.parts; }
    const std::vector<InspectorPart>& second() const { return second_.parts; }

private:
    struct Kept {
        std::shared_ptr<const Story> story = nullptr;
        std::vector<InspectorPart> parts = {};

        void update(const std::shared_ptr<const Story>& now) {
            if (story == now) return;
            story = now;
            parts = now ? inspector(*now) : std::vector<InspectorPart>();
        }
    };
    Kept first_, second_;
};

/// Returns the number's value as it is written alone.
std::string written(const InspectedNumber& number, NumberForm form);

/// Returns the value and its bound as they are written side by side: "2500" and "± 3.1e-10". The bound is empty if
/// there is none.
WithBound written_with_bound(const InspectedNumber& number, NumberForm form);

/// Returns the part's note with its number in that form.
std::string note(const InspectorPart& part, NumberForm form);

/// Returns by how much the second row's numbers are greater than the first's, each difference rounded to a double and
/// written with six digits; empty if the rows have no numbers that can be subtracted, or all are equal.
std::string differences(const InspectorRow& first, const InspectorRow& second);

/// Everything that is known about a number, with all digits.
struct NumberFact {
    std::string path;  ///< JSON pointer
    std::string name, text;
};
std::vector<NumberFact> facts(const InspectedNumber& number);

/// Returns how many bits the scalar of a story's steps has.
int digits_of_steps(const Options& options);

}  // namespace glassbox
