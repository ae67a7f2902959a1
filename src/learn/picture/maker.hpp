#pragma once
#include <functional>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>

#include "learn/build/compile_error.hpp"
#include "learn/build/compiler.hpp"
#include "learn/course/workspace.hpp"
#include "learn/picture/drawing.hpp"

namespace glassbox::learn::mine {

/// How a learner's picture stands.
enum class Stand {
    not_there,  ///< a header is not there: the lesson is not begun, or a file was deleted
    compiling,
    does_not_compile,  ///< `error` says where, if the compiler does
    drawing,           ///< what is drawn already is in `drawing`
    drawn,
    not_written,  ///< a function was called that is not written yet
    failed,       ///< it crashed, or did not end
};

/// A learner's picture, and what there is to say of it.
struct PictureUpdate {
    Stand stand = Stand::compiling;
    std::string words;                       ///< one or two sentences; no full stop
    std::optional<CompileError> error;       ///< with does_not_compile
    std::optional<Spot> spot;                ///< the pixel that the words are about
    std::shared_ptr<const Drawing> drawing;  ///< as far as it is drawn; null: not begun
    std::string said;                        ///< what the code printed, from the beginning
    double compile_seconds = 0;              ///< 0 where nothing needed compiling
    double draw_seconds = 0;
};

/// Makes pictures with a learner's headers. One thread at a time may use it.
class Maker {
public:
    /// Compiles the lesson's headers, if they have changed, and lets them draw the scene. `tell` is given every change
    /// as it comes. Throws Error if the machine cannot do it: there is no compiler, or no room.
    void make(const Workspace& workspace, const Exercise& exercise, const Scene& scene, const Options& options,
              const std::function<void(PictureUpdate)>& tell, const std::stop_token& stop = {});

private:
    std::optional<Compiler> compiler_;
};

}  // namespace glassbox::learn::mine
