#pragma once
#include <algorithm>
#include <array>
#include <bit>
#include <limits>

namespace glassbox {

/// How many seconds a picture takes in each size, measured on those already made: 1/factor of its width and height, for
/// the factors 1, 2, 4, 8, 16.
class Pace {
public:
    static constexpr int coarsest = 16;

    Pace() { seconds_.fill(std::numeric_limits<double>::infinity()); }

    /// Infinity if it is not known.
    double seconds(int factor) const { return seconds_[index(factor)]; }
    /// Limits the effect of a picture that was slow or quick by chance. What makes one size slower or quicker, as other
    /// work of the machine, is expected to do so to finer ones: else one that was too slow once would not be tried
    /// again while the view turns.
    void note(int factor, double seconds) {
        const std::size_t at = index(factor);
        const double known = seconds_[at];
        if (known == std::numeric_limits<double>::infinity()) {
            seconds_[at] = std::max(seconds, 1e-9);  // a clock may stand still
            return;
        }
        const double change = std::clamp(seconds / known, 0.8, 1.25);
        for (std::size_t size = 0; size <= at; ++size) seconds_[size] *= change;
    }

    /// Returns the finest size that is known to take less than this; `otherwise` if none is.
    int finest_within(double seconds, int otherwise) const {
        for (int factor = 1; factor < otherwise; factor *= 2)
            if (this->seconds(factor) < seconds) return factor;
        return otherwise;
    }

private:
    static std::size_t index(int factor) { return static_cast<std::size_t>(std::countr_zero(unsigned(factor))); }

    std::array<double, 5> seconds_;
};

}  // namespace glassbox
