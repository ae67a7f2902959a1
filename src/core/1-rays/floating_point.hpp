#pragma once
#include <cfloat>

// The lessons' error bounds hold for IEEE arithmetic as written: no reordering, no wider intermediate results.
#ifdef __FAST_MATH__
#error "Glassbox must not be compiled with -ffast-math: it lets the compiler reorder sums, and every bound is lost"
#endif
static_assert(FLT_EVAL_METHOD == 0, "Glassbox needs each operation rounded to its own type (on x86: SSE2, not x87)");
