#pragma once
#include <memory>
#include <optional>
#include <string>

#include "explain/recorded_pixel.hpp"
#include "learn/build/first_error.hpp"
#include "learn/picture/picture_update.hpp"

namespace glassbox::learn::mine {

/// A pixel's steps by a learner's code, and what there is to say of them: values alone.
struct RecordingUpdate {
    Stand stand = Stand::compiling;              ///< `drawn` where all steps are there
    std::string words;                           ///< one or two sentences; no full stop
    std::optional<CompileError> error;           ///< with does_not_compile
    std::shared_ptr<const RecordedPixel> pixel;  ///< null: no step is there
    std::string said;                            ///< what the code printed, from the beginning
    double compile_seconds = 0;                  ///< 0 where nothing needed compiling
};

}  // namespace glassbox::learn::mine
