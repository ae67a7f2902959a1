#pragma once

namespace glassbox {

/// How the inspector writes numbers.
enum class NumberForm {
    brief,  ///< six digits; beside its bound, as many as that deserves
    full,   ///< as many as tell it from its neighbours, as in `glassbox explain --json`
    hex,    ///< to the bit
};

}  // namespace glassbox
