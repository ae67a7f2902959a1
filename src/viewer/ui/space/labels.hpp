#pragma once
#include <string>
#include <vector>

#include <imgui.h>

namespace glassbox {

/// Places words beside points so that they do not cover each other: the first ones get the best places.
class Labels {
public:
    Labels(ImDrawList& list, ImVec2 least, ImVec2 greatest, ImU32 ground)
        : list_(list), least_(least), greatest_(greatest), ground_(ground) {}

    /// Keeps a rectangle free of words.
    void keep_free(ImVec2 least, ImVec2 greatest) { taken_.push_back({least.x, least.y, greatest.x, greatest.y}); }

    /// Keeps words off a line, as long as there is room elsewhere.
    void keep_off_line(ImVec2 from, ImVec2 to) { lines_.push_back({from.x, from.y, to.x, to.y}); }

    /// Draws the words near the point, at least `gap` away; not at all if there is no room. Words that others have
    /// pushed away are joined to their point by a line.
    void put(ImVec2 point, float gap, const std::string& words, ImU32 color);

private:
    bool is_free(const ImVec4& place) const;
    bool is_off_lines(const ImVec4& place) const;
    bool put_at(const ImVec4& place, ImVec2 point, bool joined, const std::string& words, ImU32 color);

    ImDrawList& list_;
    ImVec2 least_, greatest_;
    ImU32 ground_;
    std::vector<ImVec4> taken_, lines_;
};

}  // namespace glassbox
