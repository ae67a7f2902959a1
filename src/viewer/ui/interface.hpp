#pragma once
#include <filesystem>
#include <functional>
#include <memory>
#include <vector>

#include "viewer/model/state/state.hpp"
#include "viewer/model/work/background.hpp"
#include "viewer/model/work/file_watch.hpp"
#include "viewer/model/work/results.hpp"
#include "viewer/platform/input.hpp"
#include "viewer/ui/panels.hpp"

namespace glassbox {

/// The whole interface: a state, its results, and the drawing of both. Needs a Dear ImGui context and a current OpenGL
/// context from its first frame to its end.
class Interface {
public:
    /// `scale` is the display's; calls `wake` from other threads when there is something new to draw.
    Interface(ViewerState state, float scale, const std::function<void()>& wake);

    /// Draws a frame into the current Dear ImGui context. Returns how many seconds it may stay if nothing happens.
    double draw(const Input& input);

    ViewerState& state() { return state_; }
    const Results& results() const { return results_; }

    /// Whether everything that the state shows has been computed and drawn.
    bool settled() const { return !results_.busy && !state_.flight; }

    /// Call it before each frame, outside of it: reloads fonts if their size has changed.
    void prepare();

private:
    void watch_files();
    void hand_over();  ///< what is to be copied
    void lay_out(const Frame& frame);

    ViewerState state_;
    float scale_;
    Results results_;
    Pictures pictures_;
    Space space_;
    Boxes boxes_;
    InspectorParts inspector_;
    ThumbnailTextures thumbnails_;
    Fonts fonts_;
    Palette palette_{};
    float loaded_text_size_ = 0;
    bool loaded_dark_ = true;
    double last_time_ = 0;
    std::shared_ptr<const Scene> scene_of_meshes_;  // whose files these are
    std::vector<std::filesystem::path> mesh_files_;
    std::function<void()> wake_;
    // Last: their threads end first.
    std::unique_ptr<FileWatch> scene_watch_, mesh_watch_, mine_watch_;
    Background background_;
};

}  // namespace glassbox
