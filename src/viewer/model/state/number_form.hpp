#pragma once

namespace glassbox {

/// How the inspector writes numbers.
enum class NumberForm {
    brief,  ///< six digits; beside a bound, as many as the bound justifies
    full,   ///< as many as distinguish it from its neighbours, as in `glassbox explain --json`
    hex,    ///< to the bit
};

}  // namespace glassbox
