#pragma once

#include "viewer/model/space/boxes_in_space.hpp"
#include "viewer/model/space/space.hpp"
#include "viewer/model/state/state.hpp"
#include "viewer/model/story/inspector.hpp"
#include "viewer/model/work/results.hpp"
#include "viewer/platform/fonts.hpp"
#include "viewer/ui/frame/thumbnail_textures.hpp"
#include "viewer/ui/picture/pictures.hpp"
#include "viewer/ui/widgets/theme.hpp"

namespace glassbox {

/// What every part of the interface draws from. The user's actions change only the state.
struct Frame {
    ViewerState& state;
    const Results& results;
    const Pictures& pictures;
    const Space& space;
    const Boxes& boxes;
    InspectorParts& inspector;  ///< kept by its page
    const Fonts& fonts;
    const Palette& palette;
    const ThumbnailTextures& thumbnails;
    double seconds;  ///< since the last frame
};

// The parts of the interface. Each fills the open Dear ImGui window or child, and nothing else.

void draw_toolbar(const Frame& frame);
void draw_picture(const Frame& frame);     ///< the picture with all that lies on it
void draw_space(const Frame& frame);       ///< the scene in space
void draw_truth(const Frame& frame);       ///< whether the pinned pixel is right, and the three tiles
void draw_inspector(const Frame& frame);   ///< the pinned pixel's story
void draw_steps(const Frame& frame);       ///< its timeline, and the source
void draw_overlay(const Frame& frame);     ///< which measurement, its legend and histogram, what stands beside
void draw_controls(const Frame& frame);    ///< all of the setup
void draw_mine(const Frame& frame);        ///< the learner's tests
void draw_status(const Frame& frame);      ///< one line
void draw_scene_menu(const Frame& frame);  ///< what can be opened, if it is shown
void draw_save_menu(const Frame& frame);   ///< what can be saved, and where, if it is shown
void draw_copy_menu(const Frame& frame);   ///< the commands of what is seen, if it is shown
void draw_notice(const Frame& frame);      ///< what has just been done, for some seconds
/// Shows why the file cannot be read, over the area of the last good picture.
void draw_file_error(const Frame& frame, ImVec2 corner, ImVec2 size);
void draw_keys(const Frame& frame);  ///< the list of keys, if it is shown

}  // namespace glassbox
