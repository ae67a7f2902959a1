#pragma once
#include <atomic>
#include <span>
#include <vector>

#include "render/measure/channel.hpp"
#include "render/measure/pixel_numbers.hpp"
#include "render/measure/why_no_value.hpp"

namespace glassbox {

/// The channels of some measurements while they are filled, pixel by pixel, by several threads.
class FilledChannels {
public:
    FilledChannels(const Scene& scene, std::span<const Measurement* const> wanted);

    /// Each pixel once.
    void fill(Pixel pixel, const PixelNumbers& numbers, const Circumstances& how);

    /// All of them; those without any value say why. To be called once, at the end.
    std::vector<std::vector<Channel>> filled(const Options& options);

private:
    /// The reason nearest to a value, of all pixels' reasons so far.
    class NearestReason {
    public:
        void consider(WhyNoValue why) {
            WhyNoValue last = last_.load(std::memory_order_relaxed);
            while (last < why && !last_.compare_exchange_weak(last, why, std::memory_order_relaxed)) {
            }
        }
        WhyNoValue get() const { return last_; }

    private:
        std::atomic<WhyNoValue> last_ = WhyNoValue::has_one;
    };

    std::span<const Measurement* const> wanted_;
    std::vector<std::vector<Channel>> channels_;
    std::vector<NearestReason> reasons_;
};

}  // namespace glassbox
