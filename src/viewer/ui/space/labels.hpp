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

    /// Draws the words near the point, at least `gap` away; not at all if there is no room.
    void put(ImVec2 point, float gap, const std::string& words, ImU32 color);

private:
    bool is_free(const ImVec4& place) const;

    ImDrawList& list_;
    ImVec2 least_, greatest_;
    ImU32 ground_;
    std::vector<ImVec4> taken_;
};

}  // namespace glassbox
