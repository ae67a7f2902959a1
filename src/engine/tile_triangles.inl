// A block's triangles before a tile's rays: what each ray needs to know of them. To be included after vectors.inl.

/// A number that is linear within the tile, value + dj·right + di·up, for each of eight triangles.
struct Linear {
    alignas(64) float value[fan_out], right[fan_out], up[fan_out];
};

/// An edge's number at a ray is not negative if the ray may hit the triangle, and above `sure` if it does, as far as
/// this edge tells.
struct Triangles {
    Linear edge[3];
    alignas(64) float sure[3][fan_out];
    Linear key;
    alignas(64) float key_error[fan_out];
    /// A bit each: those that some ray may hit, not behind all that was met; and those that may face either way.
    std::uint32_t left = 0, unoriented = 0;
};

/// The same number in doubles, while it is being found.
struct Line {
    Doubles value, right, up;

    /// The most that it differs from its value.
    HWY_ATTR Doubles spread() const { return half_tile * (abs(right) + abs(up)); }
    HWY_ATTR Doubles least() const { return value - spread(); }
    HWY_ATTR Doubles most() const { return value + spread(); }
    HWY_ATTR Doubles size() const { return abs(value) + spread(); }

    HWY_ATTR void store(std::size_t at, Linear& to) const {
        store_as_floats(value, to.value + at);
        store_as_floats(right, to.right + at);
        store_as_floats(up, to.up + at);
    }

    friend HWY_ATTR Line operator+(const Line& a, const Line& b) {
        return {a.value + b.value, a.right + b.right, a.up + b.up};
    }
    friend HWY_ATTR Line operator*(const Doubles& factor, const Line& line) {
        return {factor * line.value, factor * line.right, factor * line.up};
    }
};

/// The tile's rays as they are held against triangles: the middle one, and the steps to its neighbours.
struct TileRays {
    bool pinhole;
    Vec3<Doubles> P, D, right, up;
    double key_scale;
    /// The most that doubles are off, for a block's triangles: a side product, E, and the determinant |A B C|, F.
    double E, F;
};

/// The errors' bounds of one triangle are made larger by 2⁻¹⁰ for their own rounding, and by 2⁻¹¹⁰ for underflow.
constexpr double larger = 1 + 0x1p-10, tiny = 0x1p-110, float_u = 0x1p-24;

/// `m` is the largest coordinate of the block's vertices as seen from the rays: E and F are as Grid has them.
HWY_INLINE HWY_ATTR TileRays tile_rays(const Grid& grid, const glassbox::Ray<double>& middle, double m) {
    const double scale = grid.pinhole ? grid.direction_scale : 1;
    return {grid.pinhole,
            broadcast(middle.P),
            broadcast(grid.direction_scale * middle.D),
            broadcast(scale * grid.right),
            broadcast(scale * grid.up),
            grid.key_scale,
            m * (m * grid.side1 + grid.side2),
            m * m * (m * grid.volume1 + grid.volume2)};
}

/// Vertices as seen from the middle ray's start, and the moments of the edges from each to the next: a = C × B of that
/// from B to C, and so on.
struct SeenTriangles {
    Vec3<Doubles> A, B, C, a, b, c;
};

/// The side products of an edge, D·moment: see Grid.
HWY_INLINE HWY_ATTR Line edge_line(const TileRays& rays, const Vec3<Doubles>& moment, const Vec3<Doubles>& from,
                                   const Vec3<Doubles>& to) {
    if (rays.pinhole) return {dot(rays.D, moment), dot(rays.right, moment), dot(rays.up, moment)};
    const Vec3<Doubles> turned = cross(to - from, rays.D);
    return {dot(rays.D, moment), dot(rays.right, turned), dot(rays.up, turned)};
}

/// The key of what the rays meet in the triangles' planes: n/d, each number with its error.
struct KeyQuotient {
    Line n;
    double n_error;
    Doubles d;
    double d_error;
};

/// t = V/sum, where V = |A B C| is off by F and the sum of the three side products by 4E. Its key is 1/t or −t.
HWY_INLINE HWY_ATTR KeyQuotient key_quotient(const TileRays& rays, const SeenTriangles& seen, const Line (&edges)[3]) {
    const double scale = rays.key_scale;
    const Doubles V = dot(seen.A, seen.a);
    const Line sum = edges[0] + edges[1] + edges[2];
    if (rays.pinhole) return {scale * sum, 4 * rays.E * scale, V, rays.F * larger};
    const Vec3<Doubles> all = seen.a + seen.b + seen.c;
    return {{scale * -V, scale * dot(rays.right, all), scale * dot(rays.up, all)},
            rays.F * scale,
            sum.value,
            4 * rays.E * larger};
}

struct Key {
    Line line;
    Doubles error;
    Mask<Doubles::Tag> oriented;  ///< whether the sign of d is sure, and so which way the triangle faces
};

/// n/d with errors N and M < 2⁻¹²|d| is off by (N + |n/d| M)/(|d| − M) at most, and 12 roundings in floats come to it.
HWY_INLINE HWY_ATTR Key key_line(const KeyQuotient& quotient) {
    const auto& [n, N, d, M] = quotient;
    const Doubles inverse = 1 / d, doubt = abs(inverse) * M;
    const Line key = inverse * n;
    const Doubles error = (abs(inverse) * N + key.size() * (doubt + 12 * float_u)) * larger + tiny;
    return {key, error, doubt < 0x1p-12};
}

/// A side product is off by E in doubles; in floats it is rounded 8 times at most, relatively to its size.
HWY_INLINE HWY_ATTR Doubles edge_error(const TileRays& rays, const Line& edge) {
    return (rays.E + 8 * float_u * edge.size()) * larger + tiny;
}

/// What the rays need to know of the triangles of a block. Whatever begins behind `least_key` counts as missed.
///
/// Where the sign of the key's denominator is sure, the side products must have it, too. Where it is not, they may have
/// either, and what is possible is not told: such triangles are seen edge-on, or from their own plane.
HWY_INLINE HWY_ATTR Triangles set_up(const TileRays& rays, const Block& block, float least_key) {
    Triangles result;
    for (std::size_t at = 0; at < fan_out; at += Doubles::count()) {
        const Vec3<Doubles> A = load(block.A, at) - rays.P, B = load(block.B, at) - rays.P,
                            C = load(block.C, at) - rays.P;
        const SeenTriangles seen{A, B, C, cross(C, B), cross(A, C), cross(B, A)};
        const Line edges[3] = {edge_line(rays, seen.a, B, C), edge_line(rays, seen.b, C, A),
                               edge_line(rays, seen.c, A, B)};
        const KeyQuotient quotient = key_quotient(rays, seen, edges);
        const Key key = key_line(quotient);

        auto left = key.line.most() + key.error >= static_cast<double>(least_key);
        if (!rays.pinhole) left = left & (key.line.least() - key.error < 0.0);
        const Doubles sign = copysign(1.0, quotient.d);
        for (int k = 0; k < 3; ++k) {
            const Doubles error = edge_error(rays, edges[k]);
            Line edge = sign * edges[k];
            edge.value = edge.value + error;
            left = left & (edge.most() >= 0.0);
            edge.store(at, result.edge[k]);
            store_as_floats((error + error) * larger, result.sure[k] + at);
        }
        key.line.store(at, result.key);
        store_as_floats(key.error, result.key_error + at);
        result.unoriented |= bits_of(!key.oriented) << at;
        result.left |= bits_of(left) << at;
    }
    for (std::uint32_t rest = result.unoriented; rest != 0; rest &= rest - 1) {
        const int at = __builtin_ctz(rest);
        result.key.value[at] = result.key.right[at] = result.key.up[at] = 0;
        result.key_error[at] = std::numeric_limits<float>::infinity();
    }
    result.left |= result.unoriented;
    const std::uint32_t all = (1u << block.count) - 1;
    result.left &= all;
    result.unoriented &= result.left;
    return result;
}

/// Looks at a triangle from its other side: s + error becomes −s + error.
inline void turn_over(Triangles& triangles, std::size_t at) {
    for (int k = 0; k < 3; ++k) {
        Linear& edge = triangles.edge[k];
        edge.value[at] = triangles.sure[k][at] - edge.value[at];
        edge.right[at] = -edge.right[at];
        edge.up[at] = -edge.up[at];
    }
}
