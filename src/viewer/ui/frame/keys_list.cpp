#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <vector>

#include "viewer/model/state/keys.hpp"
#include "viewer/ui/panels.hpp"
#include "viewer/ui/widgets/wrapped.hpp"

namespace glassbox {

namespace {

/// A row of the list: what is pressed, and what it does; or the title of a group.
struct Row {
    std::string pressed, does;
    bool is_title = false;
};

std::vector<Row> rows() {
    std::vector<Row> all;
    std::string_view group;
    const std::span<const KeyBinding> bindings = key_bindings();
    for (std::size_t i = 0; i < bindings.size();) {
        const KeyBinding& binding = bindings[i];
        if (binding.group != group) {
            group = binding.group;
            all.push_back({"", std::string(group), true});
        }
        // Keys without words of their own belong to the previous key.
        std::string labels(binding.label);
        for (++i; i < bindings.size() && bindings[i].what.empty(); ++i) labels += fmt::format(" {}", bindings[i].label);
        all.push_back({std::move(labels), std::string(binding.what)});
    }
    all.push_back({"", "Mouse", true});
    all.push_back({"Wheel", "zoom at the cursor"});
    all.push_back({"Drag", "move the picture; in space, turn the view of the scene"});
    all.push_back({"Ctrl+Drag", "turn the picture's view; so does the right button"});
    all.push_back({"Click", "pin a pixel: all its numbers are on the right"});
    all.push_back({"Shift+Click", "pin a second one, to compare"});
    return all;
}

float widest(const std::vector<Row>& rows, std::string Row::*words) {
    float width = 0;
    for (const Row& row : rows) width = std::max(width, ImGui::CalcTextSize((row.*words).c_str()).x);
    return width;
}

}  // namespace

void draw_keys(const Frame& frame) {
    if (!frame.state.keys_shown) return;
    const ImGuiViewport* viewport = ImGui::GetMainViewport();
    const ImVec2 middle{viewport->WorkPos.x + viewport->WorkSize.x / 2, viewport->WorkPos.y + viewport->WorkSize.y / 2};
    const ImVec2 most{viewport->WorkSize.x * .95f, viewport->WorkSize.y * .95f};
    ImGui::SetNextWindowPos(middle, ImGuiCond_Always, {.5f, .5f});
    ImGui::SetNextWindowSizeConstraints({0, 0}, most);
    ImGui::SetNextWindowFocus();
    constexpr ImGuiWindowFlags flags =
        ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoSavedSettings;
    if (ImGui::Begin("Keys", &frame.state.keys_shown, flags) &&
        ImGui::BeginTable("keys", 2, ImGuiTableFlags_SizingFixedFit)) {
        const std::vector<Row> all = rows();
        const ImGuiStyle& style = ImGui::GetStyle();
        const float room = most.x - 2 * style.WindowPadding.x - 4 * style.CellPadding.x - style.ScrollbarSize;
        const float left = std::min(widest(all, &Row::pressed), .32f * room), right = room - left;
        for (const Row& row : all) {
            ImGui::TableNextRow();
            ImGui::TableNextColumn();
            ImGui::TextUnformatted(wrapped(row.pressed, left).c_str());
            ImGui::TableNextColumn();
            ImGui::PushStyleColor(ImGuiCol_Text, row.is_title ? frame.palette.accent : frame.palette.text);
            ImGui::TextUnformatted(wrapped(row.does, right).c_str());
            ImGui::PopStyleColor();
        }
        ImGui::EndTable();
    }
    ImGui::End();
}

}  // namespace glassbox
