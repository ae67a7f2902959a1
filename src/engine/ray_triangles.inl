// A block's triangles before a single ray: which it may meet, and between which t. To be included after vectors.inl.

constexpr float float_u = 0x1p-24f;

/// A ray as it is held against triangles: its axes renamed, so that its direction is longest along z, and everything
/// sheared along x and y, so that the direction becomes (0, 0, D.z). Side products are then those of two dimensions
/// (Woop, Benthin and Wald, "Watertight Ray/Triangle Intersection", 2013). What begins at a t of `from` or before does
/// not count.
struct ShearedRay {
    std::size_t x, y, z;
    double P_x, P_y, P_z, shear_x, shear_y, per_D_z;
    double start_error, from;
    float float_shear_x = static_cast<float>(shear_x), float_shear_y = static_cast<float>(shear_y),
          float_per_D_z = static_cast<float>(per_D_z);
};

inline ShearedRay sheared(const BoxRay& from) {
    const double(&P)[BoxRay::lanes] = from.P, (&D)[BoxRay::lanes] = from.d;
    // Without a branch: which way a ray runs nobody can foresee.
    const double along_x = std::abs(D[0]), along_y = std::abs(D[1]), along_z = std::abs(D[2]);
    const std::size_t more_y = along_y > along_x, most_z = along_z > std::max(along_x, along_y);
    const std::size_t z = more_y + most_z * (2 - more_y);
    constexpr std::size_t next[] = {1, 2, 0};
    const std::size_t x = next[z], y = next[x];
    const double per_D_z = 1 / D[z];
    return {x, y, z, P[x], P[y], P[z], D[x] * per_D_z, D[y] * per_D_z, per_D_z, from.start_error, -from.shift};
}

/// A block as such a ray sees it, in the block's units: see for_each_met.
struct SeenBlock {
    FanOfFloats q_x, q_y, shear_x, shear_y, E;
    double p_z;  ///< the block's origin as seen from the ray's start, along z

    HWY_ATTR SeenBlock(const ShearedRay& ray, const Block& block)
        : shear_x(ray.float_shear_x), shear_y(ray.float_shear_y) {
        const double per_unit = block.per_unit;
        const double p_x = (block.origin[ray.x] - ray.P_x) * per_unit, p_y = (block.origin[ray.y] - ray.P_y) * per_unit;
        p_z = (block.origin[ray.z] - ray.P_z) * per_unit;
        const auto x = static_cast<float>(p_x - p_z * ray.shear_x), y = static_cast<float>(p_y - p_z * ray.shear_y);
        q_x = x;
        q_y = y;
        const float c_times_2_22 =
            std::abs(static_cast<float>(p_z)) * 0x1p-28f + static_cast<float>(ray.start_error * per_unit) * 0x1p23f;
        const float S = std::max(std::abs(x), std::abs(y)) + (2 + c_times_2_22);
        E = S * S * (21 * float_u);
    }
};

/// The corners of eight triangles as such a ray sees them.
struct ShearedCorner {
    FanOfFloats x, y, z;

    HWY_ATTR ShearedCorner(const ShearedRay& ray, const SeenBlock& seen, const float (&of)[3][fan_out], std::size_t at)
        : z(FanOfFloats::load(of[ray.z] + at)) {
        x = less_product(FanOfFloats::load(of[ray.x] + at), z, seen.shear_x) + seen.q_x;
        y = less_product(FanOfFloats::load(of[ray.y] + at), z, seen.shear_y) + seen.q_y;
    }
};

/// Calls `take(at, sure, low, high)` for each of a block's triangles that the ray may meet, between two t; `sure` says
/// that it does.
///
/// In the block's units, as seen from its origin, corners are −1 to 1. Where the ray passes there is found in doubles,
/// (q_x, q_y), and everything else in floats, u = 2⁻²⁴. With p the block's origin as seen from the ray's start, in
/// these units, Q = max(|q_x|, |q_y|), and |D.x/D.z|, |D.y/D.z|, |1/D.z| ≤ 1:
/// - q_x = p.x − p.z D.x/D.z is off by 7·2⁻⁵³ max(|p.x|, |p.y|, |p.z|), which is at most Q + |p.z|, and by 2δ where the
///   ray's start is off by δ: together by less than c + 2⁻⁵⁰Q, where c = 2⁻⁵⁰|p.z| + 2δ.
/// - A corner's sheared coordinate, v.x − v.z D.x/D.z + q_x, is at most R = 2 + Q, and in floats off by 8u + 2uQ: for
///   v, D.x/D.z and q_x, and for its own rounding. Together with what q_x is off that is no more than e = 4uR + c.
/// - A side product, a difference of two products, is off by 4(R + 2e)e, and by its own rounding, 4u(R + 2e)²: together
///   by (R + 2c)(20uR + 4c), and a little, so by less than E = 21u(R + 2²²c)². Its sign is sure where it is farther
///   from 0.
/// - A corner's tᵢ is t₀ + τᵢ, that of the block's origin and τᵢ = v.z/D.z, which is off by 4u; F = 5u.
/// - A hit's t is the mean of the corners' tᵢ weighted by the side products, which have one sign: it lies between the
///   least and the greatest tᵢ. With weights that are off by E it is off by no more than 3E times the corners' distance
///   in t over what their sum has for sure, see FilteredPredicates::sure_range, and that is at least half of the sum if
///   it is more than 7E. The mean's own rounding is 7u at most.
/// What underflow takes is nothing to E, which is 84u at least. No corner's coordinate is larger than S = R + 2²²c, so
/// that where a product overflows E does, too: nothing is missed then, and nothing sure. Where only a difference of
/// products overflows its sign is right; and a triangle that the ray meets has |q| ≤ 2 + c and a little, so that with a
/// finite E nothing of it overflows.
template <class Take>
HWY_INLINE HWY_ATTR void for_each_met(const ShearedRay& ray, const Block& block, const Take& take) {
    const SeenBlock seen(ray, block);
    const FanOfFloats& E = seen.E;
    for (std::size_t at = 0; at < fan_out; at += FanOfFloats::count()) {
        const ShearedCorner A(ray, seen, block.A, at), B(ray, seen, block.B, at), C(ray, seen, block.C, at);
        const FanOfFloats a = less_product(B.x * C.y, B.y, C.x), b = less_product(C.x * A.y, C.y, A.x),
                          c = less_product(A.x * B.y, A.y, B.x);
        const FanOfFloats least = min(min(a, b), c), most = max(max(a, b), c);
        const auto missed = (most > E) & (least < -E);
        if (none(!missed)) continue;

        constexpr float F = 5 * float_u, wider = 1 + 0x1p-10f;  // the last for the bounds' own rounding
        const FanOfFloats per_D_z = ray.float_per_D_z;
        const FanOfFloats tau_A = A.z * per_D_z, tau_B = B.z * per_D_z, tau_C = C.z * per_D_z;
        const FanOfFloats nearest = min(min(tau_A, tau_B), tau_C), farthest = max(max(tau_A, tau_B), tau_C);
        const FanOfFloats sum = a + b + c, per_sum = 1.0f / sum;
        const FanOfFloats middle = a * per_sum * tau_A + b * per_sum * tau_B + c * per_sum * tau_C;
        const FanOfFloats off = E * abs(per_sum) * (farthest - nearest + 2 * F) * (6 * wider) + (F + 8 * float_u);
        const auto one_sign = (max(least, -most) > E) & (abs(sum) > E * (7 * wider));
        alignas(32) float low[fan_out], high[fan_out];
        select(one_sign, middle - off, nearest - F).store(low + at);
        select(one_sign, middle + off, farthest + F).store(high + at);
        const std::uint32_t sure = bits_of(one_sign) << at;
        const double unit = block.unit(), t_0 = seen.p_z * ray.per_D_z * unit;
        // Of t_0, and of the two sums below.
        const double t_error = 0x1p-49 * (std::abs(t_0) + unit) + 1.01 * ray.start_error;
        for (std::uint32_t rest = (bits_of(!missed) << at) & ((1u << block.count) - 1); rest != 0; rest &= rest - 1) {
            const auto one = static_cast<std::uint32_t>(__builtin_ctz(rest));
            const double t_low = t_0 + unit * static_cast<double>(low[one]) - t_error;
            const double t_high = t_0 + unit * static_cast<double>(high[one]) + t_error;
            if (t_high < ray.from) continue;
            take(one, (sure >> one & 1) != 0 && t_low > ray.from, t_low, t_high);
        }
    }
}
