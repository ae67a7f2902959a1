#pragma once
#include <functional>
#include <optional>
#include <stop_token>

#include "learn/build/compiler.hpp"
#include "learn/course/workspace.hpp"
#include "learn/picture/picture_update.hpp"
#include "learn/picture/recording.hpp"
#include "learn/picture/written.hpp"
#include "render/options.hpp"
#include "scene/scene.hpp"

namespace glassbox::learn::mine {

/// Makes pictures with a learner's headers, and records the steps of a pixel. One thread at a time may use it.
class Maker {
public:
    /// Compiles the headers of these lessons, one at least, if they have changed, and lets them draw the scene; all
    /// other lessons' are ours. `tell` is given every change as it comes. Throws Error if the machine cannot do it:
    /// there is no compiler, or no room.
    void make(const Workspace& workspace, const Lessons& lessons, const Scene& scene, const Options& options,
              const std::function<void(PictureUpdate)>& tell, const std::stop_token& stop = {});

    /// The same with all lessons that draw in double and are finished; each update says which.
    void make_with_all(const Workspace& workspace, const Scene& scene, const Options& options,
                       const std::function<void(PictureUpdate)>& tell, const std::stop_token& stop = {});

    /// Compiles these lessons' headers, one at least, in numbers that record what is done with them, if they have
    /// changed, and traces a pixel. Otherwise as `make`.
    void record(const Workspace& workspace, const Lessons& lessons, const ToRecord& what,
                const std::function<void(RecordingUpdate)>& tell, const std::stop_token& stop = {});

    /// The same with all lessons that draw in double and are finished.
    void record_with_all(const Workspace& workspace, const ToRecord& what,
                         const std::function<void(RecordingUpdate)>& tell, const std::stop_token& stop = {});

private:
    std::optional<Compiler> compiler_;
};

}  // namespace glassbox::learn::mine
