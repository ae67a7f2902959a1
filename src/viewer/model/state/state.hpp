#pragma once
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "explain/questions.hpp"
#include "render/measure/minus.hpp"
#include "render/measure/spacing.hpp"
#include "scene/scene.hpp"
#include "viewer/model/files/copy_menu.hpp"
#include "viewer/model/files/save_menu.hpp"
#include "viewer/model/files/scene_menu.hpp"
#include "viewer/model/state/history.hpp"
#include "viewer/model/state/notice.hpp"
#include "viewer/model/state/number_form.hpp"
#include "viewer/model/state/picture_view.hpp"
#include "viewer/model/state/setup_changes.hpp"
#include "viewer/model/state/stepping.hpp"
#include "viewer/model/work/failing_test.hpp"
#include "viewer/model/work/mine.hpp"

namespace glassbox {

/// Values of a measurement, whose pixels stand out in the picture.
struct Brush {
    std::string measurement;
    double from, to;  ///< both included

    bool operator==(const Brush&) const = default;
};

/// What is laid over the picture, or shown beside it.
struct Overlay {
    std::string measurement;     ///< its name; empty: none
    std::optional<Minus> minus;  ///< the same by other settings, which is subtracted where that has a meaning
    double opacity = 1;
    std::optional<std::pair<double, double>> range;  ///< of its colours; otherwise the measurement's own
    SetSpacing spacing;                              ///< of its colours; otherwise the measurement's own
    std::optional<Brush> brush;                      ///< counts while it is of this measurement
    bool legend_shown = true;                        ///< on the picture

    bool operator==(const Overlay&) const = default;
};

/// The options of the overlay page.
struct OverlayPage {
    std::string filter;      ///< of the list of measurements
    bool log_counts = true;  ///< of the histogram: few pixels can be seen beside many
};

/// What is shown on the right of the split.
enum class Beside {
    nothing,          ///< one picture, the overlay over all of it
    overlay,          ///< the overlay, on the right only
    other,            ///< the same scene by another scalar and other rules
    difference,       ///< where that picture differs from this
    mine,             ///< the same scene by the learner's own code
    mine_difference,  ///< where that picture differs from this
};

/// How the picture follows the size of the place where it is shown.
enum class Fit {
    none,            ///< zoom and place are the user's
    whole_multiple,  ///< the same, but one to one or by a whole number where there is room: all pixels look equally
                     ///< large
    as_fits,         ///< centred, as large as fits
};

/// How the interface looks.
struct Appearance {
    bool dark = true;
    float text_size = 18;  ///< pixels of a line, before the display's own scale

    bool operator==(const Appearance&) const = default;
};

inline constexpr float least_text_size = 12, greatest_text_size = 48;

/// The pages of the panel on the right.
enum class Page { inspector, steps, overlay, controls, mine };

/// The space view's camera: it looks at the scene's middle from this direction.
struct Orbit {
    double azimuth = -60, elevation = 25;  ///< degrees
    double distance = 1;                   ///< 1: all of the scene is in sight
    Point pan = {};                        ///< how far all is shifted, as parts of the pane's width and height

    bool operator==(const Orbit&) const = default;
};

/// The camera in space on its way, as fast as eyes can follow.
struct Flight {
    bool to_hit = true;  ///< otherwise back to where all is in sight
    Orbit from;
    double elapsed = 0;  ///< seconds
};

/// "Watch it trace": how many pixels of the picture have been shown, in the order of the paper's loops.
struct Watching {
    bool on = false;       ///< otherwise the whole picture is shown
    bool running = false;  ///< otherwise it pauses
    double shown = 0;      ///< pixels
    double pixels_per_second = 20000;
};

/// "Predict first": what is to come on the timeline is hidden until the reader has said what to expect.
struct Predicting {
    bool on = false;
    Answers answers;          ///< to the questions of the pinned pixel's story
    std::uint64_t story = 0;  ///< which story that is: Results::story_serial
    Score here, before;       ///< of that story, and of those before it
    std::string typed;        ///< a number of bits
};

/// Everything that the viewer's user has chosen and opened. The interface draws it, keys and scripts change it; what is
/// computed from it is in Results.
struct ViewerState {
    std::filesystem::path file;
    std::shared_ptr<const Scene> scene;  ///< as the file says it, the last time that it could be read; never null
    std::string file_error;              ///< why the file cannot be read now; empty if it can
    History<Setup> setup;

    PictureView view;
    Point area;  ///< the size of the place where the picture is shown, as last drawn
    Fit fit = Fit::whole_multiple;
    std::optional<Pixel> hovered, pinned, compared;
    /// The number of the surface that the mouse was on in the last frame, and is on in this one, in any part of the
    /// window.
    std::optional<std::size_t> pointed_surface, pointing_at;
    bool pins_at_first = false;  ///< a pixel is pinned as soon as the picture is there

    Overlay overlay;
    OverlayPage overlay_page;
    Beside beside = Beside::nothing;
    double split = 0.5;                 ///< where the split is, from the picture area's left (0) to its right (1)
    Options other;                      ///< what `Beside::other` is computed by: its scalar and rules count
    MineChoice mine;                    ///< what `Beside::mine` is computed by
    std::optional<LookedAt> looked_at;  ///< the test whose ray is the scene

    std::size_t step = 0;  ///< on the timeline of the pinned pixel
    bool playing = false;
    double steps_per_second = 4;  ///< while it plays
    double since_step = 0;        ///< how much of the way to the next step is over
    Stepping stepping;
    Predicting predicting;
    Watching watching;

    Page page = Page::inspector;
    float side_width = 0.4f;  ///< of the panel on the right, as a part of the window's
    bool space_shown = true;
    float space_height = 0.28f;  ///< a part of the window's
    Orbit orbit;
    std::optional<Flight> flight;
    std::optional<int> box_level;                ///< the level of the engine's hierarchy whose boxes are drawn in space
    NumberForm number_form = NumberForm::brief;  ///< of the inspector
    bool keys_work_buttons = false;              ///< arrows move from button to button, the space bar presses one
    bool keys_shown = false;
    std::optional<std::size_t> tour;  ///< the stop where it is
    bool leaving = false;             ///< the window is to be closed
    SceneMenu scene_menu;
    SaveMenu save_menu;
    CopyMenu copy_menu;
    std::optional<Saving> saving;  ///< what is being written
    Notice notice;
    std::string to_copy;         ///< for others to paste; the interface hands it over
    bool turning = false;        ///< the mouse, dragged over the picture, turns the view
    bool light_refused = false;  ///< what was typed for the light has no direction
    Appearance appearance;
};

/// Pins a pixel, or none: its timeline is at its beginning and does not play.
void pin(ViewerState& state, const std::optional<Pixel>& pixel);

/// Returns a state with the scene of a file opened. Throws Error if it cannot be read.
ViewerState opened(const std::filesystem::path& file);

/// Returns the files that the scene's meshes were read from, each once.
std::vector<std::filesystem::path> mesh_files(const Scene& scene);

/// Sets up what the scene's file says makes its numbers fail, if it says so, as a change that can be undone; and lays
/// `verdict` over the picture.
void show_failing(ViewerState& state);

/// Whether the file says so, and it is not set up already.
bool can_show_failing(const ViewerState& state);

/// Reads the file again and keeps the changes that the user made; on an error the last good scene stays, and
/// `file_error` says why.
void reload(ViewerState& state);

/// Opens another file, and drops pins and changes. On an error everything stays, and `file_error` says why.
void open(ViewerState& state, const std::filesystem::path& file);

}  // namespace glassbox
