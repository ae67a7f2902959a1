// What a library linked with -ffast-math does to every program that loads it.
#include <xmmintrin.h>

namespace {
const bool set = (_mm_setcsr(_mm_getcsr() | 0x8040), true);  // flush to zero, denormals are zero
}
