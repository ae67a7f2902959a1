// A node's eight boxes before a tile's rays. To be included after vectors.inl.

/// What is linear in x, in the corner of each child's box where it is least, or most: see Bounds. `sides` is where the
/// node's sides begin.
HWY_INLINE HWY_ATTR FanOfFloats in_corners(const Bounds& b, const std::size_t (&corner)[3], float first,
                                           const float* sides) {
    FanOfFloats sum = first;
    for (int k = 0; k < 3; ++k) sum = multiply_add(b.w[k], FanOfFloats::load(sides + corner[k]), sum);
    return sum;
}
HWY_INLINE HWY_ATTR FanOfFloats least_in_boxes(const Bounds& b, const float* sides) {
    return in_corners(b, b.least_corner, b.low, sides);
}
HWY_INLINE HWY_ATTR FanOfFloats most_in_boxes(const Bounds& b, const float* sides) {
    return in_corners(b, b.most_corner, b.high, sides);
}

/// How far from the tile's middle a box begins and ends, in pixels to the right or upwards.
struct Extent {
    FanOfFloats from, to;
};

/// In a pinhole's view what is linear in x is t times that, and t ranges from the box's nearest corner to its farthest.
/// A box around the rays' start lies everywhere.
HWY_INLINE HWY_ATTR Extent in_perspective(const Extent& times_t, const FanOfFloats& t_least,
                                          const FanOfFloats& t_most) {
    constexpr float infinity = std::numeric_limits<float>::infinity();
    const FanOfFloats by_near = 1.0f / t_least, by_far = 1.0f / t_most;
    const auto around_start = t_least < 0x1p-100f;
    return {select(around_start, -infinity, min(times_t.from * by_near, times_t.from * by_far)),
            select(around_start, infinity, max(times_t.to * by_near, times_t.to * by_far))};
}

/// The tile's columns, or rows, that lie within an extent, counted from the first; none if `from` is greater than `to`.
/// What rounding may move is allowed for twice, for the ray and for the box.
struct Lines {
    FanOfFloats from, to;

    HWY_INLINE HWY_ATTR Lines(const Extent& extent, double off_by) {
        constexpr auto first = static_cast<float>(half_tile);
        const auto slack = static_cast<float>(2 * off_by);
        from = ceil(max(extent.from + (first - slack), 0.0f));
        to = floor(min(extent.to + (first + slack), tile_side - 1.0f));
    }
    HWY_INLINE HWY_ATTR Mask<FanOfFloats::Tag> are_some() const { return from <= to; }
};

/// Some parts of a tile: their columns and rows, from the first to the last, eight bits each.
struct PartsOfTile {
    std::int32_t bits;

    int left() const { return bits & 255; }
    int right() const { return bits >> 8 & 255; }
    int bottom() const { return bits >> 16 & 255; }
    int top() const { return bits >> 24 & 255; }
};
inline constexpr PartsOfTile all_parts{(parts_across - 1) << 8 | (parts_across - 1) << 24};

/// The parts that hold some of these columns and rows, for each child, as bits; the first where there are none.
HWY_INLINE HWY_ATTR void store_parts(const Lines& columns, const Lines& rows, std::int32_t* to) {
    const hn::RebindToSigned<FanOfFloats::Tag> words;
    const auto are_some = columns.are_some() & rows.are_some();
    const auto part = [&](const FanOfFloats& line) HWY_ATTR {
        return hn::ConvertTo(words, select(are_some, line * (1.0f / part_side), 0.0f).v);
    };
    const auto across = hn::Or(part(columns.from), hn::ShiftLeft<8>(part(columns.to)));
    const auto upwards = hn::Or(part(rows.from), hn::ShiftLeft<8>(part(rows.to)));
    hn::Store(hn::Or(across, hn::ShiftLeft<16>(upwards)), words, to);
}

/// The children whose boxes are not within the engine's near reach: of these `Bounds` say nothing.
HWY_INLINE HWY_ATTR std::uint32_t beyond_reach(const Node& node, float near_reach, std::size_t at) {
    FanOfFloats most = 0.0f;
    for (int k = 0; k < 3; ++k)
        most = max(
            most, max(-FanOfFloats::load(node.side[Node::lo][k] + at), FanOfFloats::load(node.side[Node::hi][k] + at)));
    return bits_of((most > near_reach) & (most < std::numeric_limits<float>::infinity()));
}

/// The children whose boxes some ray of the tile may meet, not beyond some t; the least t in each box, and the parts of
/// the tile in which it is seen.
struct ChildrenMet {
    std::uint32_t which = 0;  ///< a bit each
    alignas(32) float entry[fan_out];
    alignas(32) std::int32_t seen_in[fan_out];  ///< as bits
};

HWY_INLINE HWY_ATTR void find_children_met(const Node& node, const Sight& sight, float t_max, ChildrenMet& result) {
    result.which = 0;
    const float* const sides = node.side[0][0];
    for (std::size_t at = 0; at < fan_out; at += FanOfFloats::count()) {
        const FanOfFloats t_least = least_in_boxes(sight.t, sides + at), t_most = most_in_boxes(sight.t, sides + at);
        const auto lines = [&](const Bounds& b) HWY_ATTR {
            const Extent seen{least_in_boxes(b, sides + at), most_in_boxes(b, sides + at)};
            return Lines(sight.pinhole ? in_perspective(seen, t_least, t_most) : seen, sight.off_by);
        };
        const auto ahead = (t_most >= 0.0f) & (t_least <= t_max);
        // Of boxes around the rays' start the smallest first: what is in them is nearest.
        select(t_least < 0.0f, 1.0f / t_least, t_least).store(result.entry + at);
        const Lines columns = lines(sight.right), rows = lines(sight.up);
        store_parts(columns, rows, result.seen_in + at);
        result.which |= bits_of(ahead & columns.are_some() & rows.are_some()) << at;
        if (!sight.some_beyond) continue;
        for (std::uint32_t beyond = beyond_reach(node, sight.near_reach, at) << at; beyond != 0; beyond &= beyond - 1) {
            const auto child = static_cast<std::uint32_t>(__builtin_ctz(beyond));
            result.which |= 1u << child;
            result.entry[child] = -std::numeric_limits<float>::infinity();
            result.seen_in[child] = all_parts.bits;
        }
    }
}

/// A child to look into, where it begins, and where in the tile it is seen.
struct TileVisit {
    std::uint32_t child;
    float entry;
    PartsOfTile seen_in;
};
