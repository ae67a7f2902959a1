// A block's triangles before a tile's rays: what each ray needs to know of them. To be included after vectors.inl.

using FanOfVectors = Vec3<FanOfFloats>;

/// The largest of a vector's coordinates.
HWY_INLINE HWY_ATTR FanOfFloats largest(const FanOfVectors& v) { return max(max(abs(v.x), abs(v.y)), abs(v.z)); }

/// w + a × b and a·b, rounded less often than by the core's formulas, where the processor multiplies and adds at once.
HWY_INLINE HWY_ATTR FanOfVectors plus_cross(const FanOfVectors& w, const FanOfVectors& a, const FanOfVectors& b) {
    return {less_product(multiply_add(a.y, b.z, w.x), a.z, b.y), less_product(multiply_add(a.z, b.x, w.y), a.x, b.z),
            less_product(multiply_add(a.x, b.y, w.z), a.y, b.x)};
}
HWY_INLINE HWY_ATTR FanOfFloats dot(const FanOfVectors& a, const FanOfVectors& b) {
    return multiply_add(a.z, b.z, multiply_add(a.y, b.y, a.x * b.x));
}

/// A number that is linear within the tile, value + dj·right + di·up, for each of eight triangles.
struct Linear {
    alignas(32) float value[fan_out], right[fan_out], up[fan_out];
};

/// An edge's number at a ray is not negative if the ray may hit the triangle, and above `sure` if it does, as far as
/// this edge tells.
struct Triangles {
    Linear edge[3];
    alignas(32) float sure[fan_out];
    Linear key;
    alignas(32) float key_error[fan_out];
    /// A bit each: those that some ray may hit, not behind all that was met; those that may face either way; and those
    /// whose key floats hardly tell.
    std::uint32_t left = 0, unoriented = 0, doubtful = 0;

    /// Looks at a triangle from its other side: s + error becomes −s + error.
    void turn_over(std::size_t at) {
        for (Linear& of : edge) {
            of.value[at] = sure[at] - of.value[at];
            of.right[at] = -of.right[at];
            of.up[at] = -of.up[at];
        }
    }

    /// Takes the key of a doubtful triangle as doubles have it. `was_negative`: as floats had its denominator.
    void take(std::size_t at, const PreciseKey& precise, bool was_negative) {
        key.value[at] = static_cast<float>(precise.value);
        key.right[at] = static_cast<float>(precise.right);
        key.up[at] = static_cast<float>(precise.up);
        key_error[at] = static_cast<float>(precise.error);
        if (precise.is_negative != was_negative) turn_over(at);
    }
};

/// The same number in vectors, while it is being found.
struct Line {
    FanOfFloats value, right, up;

    /// The most that it differs from its value.
    HWY_ATTR FanOfFloats spread() const { return static_cast<float>(half_tile) * (abs(right) + abs(up)); }
    HWY_ATTR FanOfFloats least() const { return value - spread(); }
    HWY_ATTR FanOfFloats most() const { return value + spread(); }
    HWY_ATTR FanOfFloats size() const { return abs(value) + spread(); }

    HWY_ATTR void store(std::size_t at, Linear& to) const {
        value.store(to.value + at);
        right.store(to.right + at);
        up.store(to.up + at);
    }

    friend HWY_ATTR Line operator*(const FanOfFloats& factor, const Line& line) {
        return {factor * line.value, factor * line.right, factor * line.up};
    }
};

HWY_INLINE HWY_ATTR Line dot(const LinearVector<FanOfVectors>& v, const FanOfVectors& by) {
    return {dot(v.value, by), dot(v.right, by), dot(v.up, by)};
}

HWY_INLINE HWY_ATTR FanOfVectors in_floats(const glassbox::Vec3<double>& a) {
    return {FanOfFloats(static_cast<float>(a.x)), FanOfFloats(static_cast<float>(a.y)),
            FanOfFloats(static_cast<float>(a.z))};
}
HWY_INLINE HWY_ATTR LinearVector<FanOfVectors> in_floats(const LinearVector<glassbox::Vec3<double>>& v) {
    return {in_floats(v.value), in_floats(v.right), in_floats(v.up)};
}

/// A tile's rays before a block, in floats.
template <bool pinhole>
struct RaysInFloats {
    const LinearVector<FanOfVectors>& D;
    LinearVector<FanOfVectors> p, p_x_D;

    HWY_ATTR RaysInFloats(const LinearVector<FanOfVectors>& directions, const RaysAtBlock& at_block)
        : D(directions), p_x_D(in_floats(at_block.p_x_D)) {
        if constexpr (pinhole) p.value = in_floats(at_block.p.value);
        else p = in_floats(at_block.p);
    }

    /// The side products of an edge that starts at A.
    HWY_INLINE HWY_ATTR Line side(const FanOfVectors& A, const FanOfVectors& edge) const {
        const FanOfFloats value = dot(edge, plus_cross(p_x_D.value, A, D.value));
        if constexpr (!pinhole) return {value, dot(edge, p_x_D.right), dot(edge, p_x_D.up)};
        return {value, dot(edge, plus_cross(p_x_D.right, A, D.right)), dot(edge, plus_cross(p_x_D.up, A, D.up))};
    }
};

/// A bound that depends on how long a triangle's edges are: at most g along each axis.
struct ErrorBound {
    float fixed, by_g, by_g2;

    HWY_ATTR FanOfFloats operator()(const FanOfFloats& g) const { return g * (g * by_g2 + by_g) + fixed; }
};

/// The errors of a block's triangles, anywhere in the tile, with u = 2⁻²⁴. Corners are at most 1 along an axis, and off
/// by u; edges e are off by (2 + g)u. |D|, |p| and |w| are the sums of the sizes of D's coordinates, of p's, and of
/// those of w = p × D, which in doubles is off by 6·2⁻⁵³|p||D| along each axis.
/// - A side product is e·w_A, where w_A = w + A × D for the corner A that the edge starts at. That is |w| + 2|D| at
///   most, summed over the axes, and off by u(3|w| + 5|D|) along each. With e's error, 3u of the sum for the dot
///   product, and 8u for what a ray makes of it, two products and two sums, and as much where it is looked for whether
///   any does: together u(|w|(2 + 15g) + |D|(4 + 39g)). If the ray's direction is off by ε it changes by 2g(|p| + 1)ε;
///   if its start is, by 2g|D|ε.
/// - N, the cross product of two edges, is at most 2g² along an axis, and off by 8ug(1 + g). The sum of the three side
///   products is D·N, off by u|D|(8g + 16g²); the determinant |A B C| is (p + A)·N, off by u(|p| + 3)(8g + 20g²). If
///   the ray is off by ε they change by 2g²ε.
/// All of them are made a little larger for their own rounding, and by 2⁻¹¹⁰ for underflow.
struct TileErrors {
    ErrorBound side, sum, volume;

    TileErrors(const TileRays& rays, const RaysAtBlock& at_block) {
        constexpr double u = 0x1p-24;
        const double D = rays.most_D, p = at_block.most_p, w = at_block.most_p_x_D;
        const double by_direction = rays.direction_error(), by_start = at_block.start_error;
        side = bound(u * (2 * w + 4 * D),
                     u * (15 * w + 39 * D) + 36 * 0x1p-53 * p * D + 2 * (p + 1) * by_direction + 2 * D * by_start, 0);
        sum = bound(0, 8 * u * D, 16 * u * D + 2 * by_direction);
        volume = bound(0, 8 * u * (p + 3), 20 * u * (p + 3) + 2 * by_start);
    }

private:
    static ErrorBound bound(double fixed, double by_g, double by_g2) {
        constexpr double larger = 1 + 0x1p-10, tiny = 0x1p-110;
        return {static_cast<float>(fixed * larger + tiny), static_cast<float>(by_g * larger),
                static_cast<float>(by_g2 * larger)};
    }
};

/// The key of what the rays meet in the triangles' planes: n/d, each number with its error.
struct KeyQuotient {
    Line n;
    FanOfFloats n_error;
    FanOfFloats d;
    FanOfFloats d_error;
};

/// t = V/sum, where V = |A B C| and `sum` is that of the three side products. Its key is 1/t or −t.
template <bool pinhole>
HWY_INLINE HWY_ATTR KeyQuotient key_quotient(const RaysInFloats<pinhole>& seen, float key_factor, const FanOfVectors& A,
                                             const FanOfVectors& N, const FanOfFloats& g, const TileErrors& errors) {
    const FanOfFloats factor = key_factor;
    const FanOfFloats V = dot(seen.p.value + A, N), V_error = errors.volume(g);
    if constexpr (pinhole) return {factor * dot(seen.D, N), factor * errors.sum(g), V, V_error};
    const Line minus_V = Line{V, dot(seen.p.right, N), dot(seen.p.up, N)};
    return {-factor * minus_V, factor * V_error, dot(seen.D.value, N), errors.sum(g)};
}

struct Key {
    Line line;
    FanOfFloats error;
    Mask<FanOfFloats::Tag> doubtful;  ///< whether d may be off by more than a part in 256, or floats overflow
};

/// n/d with errors N and M < |d|/256 is off by (N + |n/d| M)/(|d| − M) at most, and 12 roundings come to it.
HWY_INLINE HWY_ATTR Key key_line(const KeyQuotient& quotient) {
    constexpr float u = 0x1p-24f, larger = 1 + 0x1p-7f, tiny = 0x1p-110f;
    const auto& [n, N, d, M] = quotient;
    const FanOfFloats inverse = 1.0f / d, doubt = abs(inverse) * M;
    const Line key = inverse * n;
    const FanOfFloats error = (abs(inverse) * N + key.size() * (doubt + 12 * u)) * larger + tiny;
    constexpr float infinity = std::numeric_limits<float>::infinity();
    return {key, error, !((doubt < 0x1p-8f) & (error < infinity))};
}

/// What the rays need to know of the triangles of a block. Whatever begins behind `least_key` counts as missed.
///
/// Where the sign of the key's denominator is sure, the side products must have it, too. Where it is not, they may have
/// either, and what is possible is not told: such triangles are seen edge-on, or from their own plane. `precise(at)` is
/// asked where floats do not tell.
template <bool pinhole, class Precise>
HWY_INLINE HWY_ATTR Triangles set_up(const RaysInFloats<pinhole>& seen, float key_factor, const TileErrors& errors,
                                     const Block& block, float least_key, const Precise& precise) {
    Triangles result;
    std::uint32_t negative = 0;
    for (std::size_t at = 0; at < fan_out; at += FanOfFloats::count()) {
        const auto corner = [&](const float(&of)[3][fan_out]) HWY_ATTR -> FanOfVectors {
            return {FanOfFloats::load(of[0] + at), FanOfFloats::load(of[1] + at), FanOfFloats::load(of[2] + at)};
        };
        const FanOfVectors A = corner(block.A), B = corner(block.B), C = corner(block.C);
        const FanOfVectors a = C - B, b = A - C, c = B - A;  // the edges
        const FanOfFloats g = max(largest(b), largest(c));   // of those that N is made of
        const KeyQuotient quotient = key_quotient(seen, key_factor, A, cross(c, b), g, errors);
        const Key key = key_line(quotient);
        const FanOfFloats sign = copysign(1.0f, quotient.d), error = errors.side(max(g, largest(a)));
        const Line edges[3] = {seen.side(B, a), seen.side(C, b), seen.side(A, c)};

        auto left = key.line.most() + key.error >= least_key;
        if (!pinhole) left = left & (key.line.least() - key.error < 0.0f);
        for (int k = 0; k < 3; ++k) {
            Line edge = sign * edges[k];
            edge.value = edge.value + error;
            left = left & (edge.most() >= 0.0f);
            edge.store(at, result.edge[k]);
        }
        (error * (2 + 0x1p-20f)).store(result.sure + at);
        key.line.store(at, result.key);
        key.error.store(result.key_error + at);
        result.doubtful |= bits_of(key.doubtful) << at;
        negative |= bits_of(sign < 0.0f) << at;
        result.left |= bits_of(left) << at;
    }
    const std::uint32_t all = (1u << block.count) - 1;
    result.doubtful &= all;
    result.left = (result.left & all) | result.doubtful;
    for (std::uint32_t rest = result.doubtful; rest != 0; rest &= rest - 1) {
        const auto at = static_cast<std::uint32_t>(__builtin_ctz(rest));
        const PreciseKey key = precise(at);
        if (key.oriented) result.take(at, key, (negative >> at & 1) != 0);
        else result.unoriented |= 1u << at;
    }
    for (std::uint32_t rest = result.unoriented; rest != 0; rest &= rest - 1) {
        const int at = __builtin_ctz(rest);
        result.key.value[at] = result.key.right[at] = result.key.up[at] = 0;
        result.key_error[at] = std::numeric_limits<float>::infinity();
    }
    return result;
}
