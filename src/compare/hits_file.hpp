#pragma once
#include <cstddef>
#include <filesystem>
#include <limits>
#include <optional>
#include <vector>

#include "render/shoot.hpp"

namespace glassbox {

/// What another program says of a ray.
struct Claim {
    Shot::Answer answer = Shot::Answer::miss;
    std::optional<std::size_t> surface;  ///< of a hit, if it is told
    std::optional<double> t;             ///< of a hit, if it is told, in units of |D|
};

/// What another program says of all rays, and with how many digits it has written t: of a t of size 10ⁿ what is less
/// than half of its last digit is the writing's.
struct Claims {
    std::vector<Claim> rays;
    int digits = 0;    ///< the most that any t has
    int decimals = 0;  ///< the most that any t has behind its point

    /// Whether no t is written with as many digits as tell numbers of its scalar apart. A few digits are no rounding:
    /// such numbers are small whole ones.
    bool is_shortened(int digits_of_scalar) const { return digits >= 5 && digits < digits_of_scalar; }
    /// Half of the last digit of a t, if they are shortened; else 0.
    double half_digit_if_shortened(double t, int digits_of_scalar) const;
};

/// So many digits tell numbers of the scalar apart, but for a last one that few need.
template <class Real>
inline constexpr int digits_of = std::numeric_limits<Real>::max_digits10 - 1;

/// Reads a table as `glassbox shoot` writes it, of `rays` rays in a scene of `surfaces` surfaces. Its header may name
/// the columns ray, verdict, surface and t in any order, and others, which are ignored; all but verdict may be left
/// out. Without ray, rows are in the order of the rays. Throws Error, with file, line and column, for what cannot be
/// meant.
Claims read_hits(const std::filesystem::path& file, std::size_t rays, std::size_t surfaces);

}  // namespace glassbox
