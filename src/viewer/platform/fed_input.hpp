#pragma once
#include <imgui.h>

#include <span>
#include <vector>

#include "viewer/platform/input.hpp"

namespace glassbox {

/// Tells the current Dear ImGui context of a mouse and of keys that no system knows of. A key that is pressed is down
/// for that one frame.
class FedInput {
public:
    FedInput();

    /// Between the renderer's NewFrame and ImGui::NewFrame.
    void feed(const Pointer& pointer, std::span<const KeyPress> keys);

private:
    std::vector<ImGuiKey> down_;  // in the frame before
};

}  // namespace glassbox
