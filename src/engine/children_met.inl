// A node's eight boxes before a single ray. To be included after vectors.inl.

/// The children that the ray meets before t_max, and where it enters each: those that it enters no later than it
/// leaves.
HWY_INLINE HWY_ATTR std::uint32_t children_met(const Node& node, const BoxRay& ray, float t_max,
                                               float (&entries)[fan_out]) {
    std::uint32_t met = 0;
    const float* const sides = node.side[0][0];
    for (std::size_t at = 0; at < fan_out; at += FanOfFloats::count()) {
        const auto entry_of = [&](int k) HWY_ATTR {
            return multiply_add(FanOfFloats::load(sides + ray.near_side[k] + at), ray.inverse[k], ray.near_offset[k]);
        };
        const auto exit_of = [&](int k) HWY_ATTR {
            return multiply_add(FanOfFloats::load(sides + ray.far_side[k] + at), ray.exit_inverse[k],
                                ray.far_offset[k]);
        };
        const FanOfFloats entry = max(max(entry_of(0), entry_of(1)), max(entry_of(2), 0.0f));
        const FanOfFloats exit = min(min(exit_of(0), exit_of(1)), min(exit_of(2), t_max));
        entry.store(entries + at);
        met |= bits_of(entry <= exit) << at;
    }
    return met;
}
