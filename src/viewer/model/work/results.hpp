#pragma once
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "explain/questions.hpp"
#include "explain/story.hpp"
#include "explain/timeline.hpp"
#include "learn/picture/picture_update.hpp"
#include "learn/picture/recording_update.hpp"
#include "learn/told_tests.hpp"
#include "render/image.hpp"
#include "render/measure/channel.hpp"
#include "render/measure/measurements.hpp"
#include "render/setup.hpp"
#include "viewer/model/files/save_menu.hpp"
#include "viewer/model/files/thumbnail.hpp"
#include "viewer/model/overlay/finder.hpp"

namespace glassbox {

struct BoxLevels;
struct SurfacesInPicture;

/// The steps of a pixel.
struct Steps {
    std::shared_ptr<const Story> story;  ///< null: none
    std::vector<Event> timeline;         ///< of that story; empty without one
    std::vector<Question> questions;     ///< of that timeline
    std::uint64_t story_serial = 0;
};

/// The steps of a pixel by the learner's code, and how that stands.
struct MineSteps : Steps {
    learn::mine::RecordingUpdate update;
};

/// A picture, perhaps a coarse one that a finer one will follow.
struct Picture {
    std::shared_ptr<const Image> image;  ///< null: none yet
    int factor = 1;                      ///< it has 1/factor of the pixels of the final one's width and height
};

/// What a measurement measured, perhaps coarsely.
struct MeasuredChannels {
    const Measurement* what = nullptr;
    std::vector<Channel> channels;
    int factor = 1;
    std::shared_ptr<const Scene> scene = {};  ///< of what
    Setup setup = {};                         ///< and how traced
    FoundPixels found = {};                   ///< the worst ones; none while it is coarse
    /// Of a difference: itself as a measurement, which `what` points to, and the two that it is the difference of.
    std::shared_ptr<const Measurement> difference = {};
    std::vector<Channel> both = {};
};

/// What was computed for a ViewerState: the newest result of each kind, kept until there is a newer one. `serial`
/// numbers rise with each new version, for caches of what is made from it.
///
/// The steps are those of our code, of the pinned pixel.
struct Results : Steps {
    Picture picture, other;  ///< the other one by another scalar or rule, or by the learner's code
    /// The state of the learner's picture; null if it is not shown, or nothing is known yet. While it has no drawing of
    /// its own, `other` is the last drawing; otherwise `other` is that drawing.
    std::shared_ptr<const learn::mine::PictureUpdate> mine;
    std::shared_ptr<const learn::ToldTests> tests;      ///< of the learner's code; null: they do not run
    std::shared_ptr<const MeasuredChannels> overlay;    ///< null: none
    MineSteps mine_steps;                               ///< of the pinned pixel; without a story: not computed, or none
    std::shared_ptr<const Story> compared;              ///< of the second pinned pixel; null: none
    std::shared_ptr<const BoxLevels> boxes;             ///< the engine's hierarchy; null: not drawn, or not there yet
    std::shared_ptr<const SurfacesInPicture> surfaces;  ///< what the pixels show; null: not asked for yet
    std::shared_ptr<const Thumbnails> thumbnails;       ///< of the scenes that are listed; null: none yet
    Saved saved;                                        ///< how the last file's writing ended
    std::uint64_t picture_serial = 0, other_serial = 0, overlay_serial = 0;
    std::uint64_t mine_serial = 0, surfaces_serial = 0;

    double progress = 1;  ///< of the picture that is being rendered, 0 to 1
    bool busy = false;    ///< something is still being computed
    std::string error;    ///< why something could not be computed; empty if nothing went wrong
};

}  // namespace glassbox
