#include <fmt/format.h>

#include "viewer/model/state/keys.hpp"
#include "viewer/ui/panels.hpp"

namespace glassbox {

void draw_keys(const Frame& frame) {
    if (!frame.state.keys_shown) return;
    const ImGuiViewport* viewport = ImGui::GetMainViewport();
    const ImVec2 middle{viewport->WorkPos.x + viewport->WorkSize.x / 2, viewport->WorkPos.y + viewport->WorkSize.y / 2};
    ImGui::SetNextWindowPos(middle, ImGuiCond_Always, {.5f, .5f});
    ImGui::SetNextWindowSizeConstraints({0, 0}, {viewport->WorkSize.x * .95f, viewport->WorkSize.y * .95f});
    ImGui::SetNextWindowFocus();
    constexpr ImGuiWindowFlags flags =
        ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoSavedSettings;
    if (ImGui::Begin("Keys", &frame.state.keys_shown, flags) &&
        ImGui::BeginTable("keys", 2, ImGuiTableFlags_SizingFixedFit)) {
        const auto row = [&](const char* left, std::string_view right) {
            ImGui::TableNextRow();
            ImGui::TableNextColumn();
            ImGui::TextUnformatted(left);
            ImGui::TableNextColumn();
            ImGui::TextUnformatted(right.data(), right.data() + right.size());
        };
        std::string_view group;
        const std::span<const KeyBinding> bindings = key_bindings();
        for (std::size_t i = 0; i < bindings.size();) {
            const KeyBinding& binding = bindings[i];
            if (binding.group != group) {
                group = binding.group;
                ImGui::PushStyleColor(ImGuiCol_Text, frame.palette.accent);
                row("", group);
                ImGui::PopStyleColor();
            }
            // Keys without words of their own belong to the previous key.
            std::string labels(binding.label);
            for (++i; i < bindings.size() && bindings[i].what.empty(); ++i)
                labels += fmt::format(" {}", bindings[i].label);
            row(labels.c_str(), binding.what);
        }
        ImGui::PushStyleColor(ImGuiCol_Text, frame.palette.accent);
        row("", "Mouse");
        ImGui::PopStyleColor();
        row("Wheel", "zoom at the cursor");
        row("Drag", "move the picture; in space, turn the view of the scene");
        row("Ctrl+Drag", "turn the picture's view; so does the right button");
        row("Click", "pin a pixel: all its numbers are on the right");
        row("Shift+Click", "pin a second one, to compare");
        ImGui::EndTable();
    }
    ImGui::End();
}

}  // namespace glassbox
