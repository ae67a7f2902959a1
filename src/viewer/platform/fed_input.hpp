#pragma once
#include <imgui.h>

#include <span>
#include <vector>

#include "viewer/platform/input.hpp"

namespace glassbox {

/// Feeds the current Dear ImGui context a simulated mouse and keyboard. A key that is pressed is down for that one
/// frame.
class FedInput {
public:
    FedInput();

    /// Call it between the renderer's NewFrame and ImGui::NewFrame.
    void feed(const Pointer& pointer, std::span<const KeyPress> keys);

private:
    std::vector<ImGuiKey> down_;  // in the previous frame
};

}  // namespace glassbox
