#pragma once
#include <vector>

#include "numerics/tape.hpp"

namespace glassbox {

class Exact;

/// How well the true value of a step is known.
enum class Known {
    exactly,        ///< in exact arithmetic: rationals with one square root
    to_long_float,  ///< in binary floats of Dyadic::long_bits bits: powers, and roots of roots
    not_at_all,  ///< a division by 0, a root of a negative number, an input that is not finite; or it depends on a sign
                 ///< that so many bits do not determine
};

/// A step after a replay: what it computed, a guaranteed bound, and what the same steps give without any rounding.
///
/// Long floats may leave open whether a true value is 0: then truth and sign are 0, and bits_lost is NaN. The distance
/// is 0 if they cannot tell the true value from the number.
///
/// The error is the sum of an own and an inherited one, with their signs. Let `best` be the scalar's result for the
/// nearest operands that it has to the true ones: own is best − truth, inherited is value − best.
struct Checked {
    double value = 0;          ///< as recorded; a long double rounded to double
    long double recorded = 0;  ///< the same, to the last digit
    double error = 0;  ///< |value − truth| is at most this, proven by running bounds; infinite: nothing is proven, or
                       ///< there is no true value
    double truth = 0;  ///< the true value, rounded once
    double distance = 0;   ///< |value − truth|, rounded once
    double bits_lost = 0;  ///< log2(ulps + 1), the distance in units of the value's last place; at most its digits
    int sign = 0;          ///< of the truth
    Known known = Known::exactly;
    double own_loss = 0;  ///< of an operation: the bits that it would lose if its operands were the true ones, each
                          ///< rounded once to the scalar; NaN if that is not known
    double inherited_loss = 0;  ///< how far it is from that result, in the same bits: what its operands' errors beyond
                                ///< such a rounding make of it
};

/// A recorded number without a check.
inline Checked unchecked(long double recorded) {
    const auto value = static_cast<double>(recorded);
    return {.value = value, .recorded = recorded, .truth = value};
}

/// Repeats a tape's operations, with bounds and without rounding. Takes inputs and constants as exact. The truth of a
/// comparison is whether it truly holds; its error is 0 if the bounds decide it, else 1.
std::vector<Checked> replay(const Tape& tape);

/// Whether long floats leave open if the true value is 0.
inline bool may_be_zero(const Checked& number) { return number.known == Known::to_long_float && number.sign == 0; }

/// Checks a double against a true value found elsewhere.
Checked checked(double value, const Exact& truth);

}  // namespace glassbox
