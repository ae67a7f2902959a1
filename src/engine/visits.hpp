#pragma once
#include <cstddef>
#include <cstdint>

#include "engine/hierarchy.hpp"

namespace glassbox::engine {

/// A child to look into, and where it begins: no ray that is under way meets it earlier.
struct Visit {
    std::uint32_t child;
    float entry;
};

/// What is still to be visited on a way through a hierarchy; of what was pushed last the nearest lies on top.
class Visits {
public:
    explicit Visits(const Visit& first) { visits_[depth_++] = first; }

    bool is_empty() const { return depth_ == 0; }
    Visit pop() { return visits_[--depth_]; }

    /// The children whose bits are set.
    void push(const Node& node, std::uint32_t children, const float (&entries)[fan_out]) {
        const std::size_t first = depth_;
        for (; children != 0; children &= children - 1) {
            const auto i = static_cast<std::uint32_t>(__builtin_ctz(children));
            const Visit one{node.child[i], entries[i]};
            std::size_t place = depth_++;
            for (; place > first && visits_[place - 1].entry < one.entry; --place) visits_[place] = visits_[place - 1];
            visits_[place] = one;
        }
    }

private:
    Visit visits_[(fan_out - 1) * most_levels + fan_out];
    std::size_t depth_ = 0;
};

}  // namespace glassbox::engine
