#pragma once
#include <stdexcept>
#include <string>

namespace glassbox {

/// What a function throws that is still to be written: "`cross` is not written yet (my/1-rays/vec3.hpp:57)".
struct NotWritten : std::logic_error {
    using std::logic_error::logic_error;
};

/// Stands where the body of a function belongs: `return not_written<Vec3<Real>>("cross");`. It fails, loudly, and says
/// which function it is and where.
template <class Result>
Result not_written(const char* function, const char* file = __builtin_FILE(), int line = __builtin_LINE()) {
    throw NotWritten(std::string("`") + function + "` is not written yet (" + file + ":" + std::to_string(line) + ")");
}

}  // namespace glassbox
