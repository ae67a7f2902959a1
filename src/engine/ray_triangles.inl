// A block's triangles before a single ray: which it may meet, and between which t. To be included after vectors.inl.

/// Which of up to eight surfaces a ray may meet, and which it does, a bit each; and between which t.
struct MayMeet {
    std::uint32_t some = 0, sure = 0;
    alignas(64) double low[fan_out], high[fan_out];
};

/// A ray as it is held against triangles: its axes renamed, so that its direction is longest along z, and everything
/// sheared along x and y, so that the direction becomes (0, 0, D.z). Side products are then those of two dimensions
/// (Woop, Benthin and Wald, "Watertight Ray/Triangle Intersection", 2013). Its start is off by `start_error` at most.
/// `farthest` is no less than any coordinate of a vertex as seen from there. What begins at a t of `from` or before
/// does not count.
struct ShearedRay {
    std::size_t x, y, z;
    double P_x, P_y, P_z, shear_x, shear_y, per_D_z, start_error, from, coarse_E;
};

/// The most that a side product is off, for corners no coordinate of which is larger than m: see may_meet.
template <class Number>
HWY_INLINE HWY_ATTR Number side_error(const Number& m, double start_error) {
    return 80 * 0x1p-53 * m * m + start_error * 20 * (m + start_error) + 0x1p-900;
}

inline ShearedRay sheared(const BoxRay& from, double farthest) {
    const double(&P)[3] = from.P, (&D)[3] = from.d;
    std::size_t z = std::abs(D[1]) > std::abs(D[0]) ? 1 : 0;
    if (std::abs(D[2]) > std::abs(D[z])) z = 2;
    const std::size_t x = z == 2 ? 0 : z + 1, y = x == 2 ? 0 : x + 1;
    const double per_D_z = 1 / D[z];
    return {x,
            y,
            z,
            P[x],
            P[y],
            P[z],
            D[x] * per_D_z,
            D[y] * per_D_z,
            per_D_z,
            from.start_error,
            -from.shift,
            side_error(farthest, from.start_error)};
}

/// The corners of eight triangles as such a ray sees them.
struct ShearedCorner {
    Doubles x, y, z, size;  ///< `size`: the largest coordinate before they were sheared

    HWY_ATTR ShearedCorner(const ShearedRay& ray, const double (&of)[3][fan_out], std::size_t at) {
        const Doubles seen_x = Doubles::load(of[ray.x] + at) - ray.P_x,
                      seen_y = Doubles::load(of[ray.y] + at) - ray.P_y;
        z = Doubles::load(of[ray.z] + at) - ray.P_z;
        x = seen_x - z * ray.shear_x;
        y = seen_y - z * ray.shear_y;
        size = max(max(abs(seen_x), abs(seen_y)), abs(z));
    }
};

/// The triangles of a block that the ray may meet at a t of `before` or less.
///
/// With m the largest coordinate of the corners as seen from P:
/// - Sheared coordinates are at most 2m, and off by 7um: u|A.x| and 4u|A.z D.x/D.z| for what they are computed from,
/// and
///   their own rounding, 2um. So a side product, a difference of two products, is off by 4·2m·7um and by its own
///   rounding, 16um²: together less than E = 80um². Its sign is sure where it is farther from 0.
/// - A corner's tᵢ = z/D.z is off by F = 4um/|D.z| at most.
/// - What the start is off, δ, moves sheared coordinates by 2δ, side products by 16δ(m + δ), and tᵢ by δ/|D.z|.
/// - A hit's t is the mean of the corners' tᵢ weighted by the side products, which have one sign: it lies between the
///   least and the greatest tᵢ. With weights that are off by E it is off by no more than 3E times the corners' distance
///   in t over what their sum has for sure, see FilteredPredicates::sure_range, and that is at least half of the sum if
///   it is more than 7E. What is rounded besides is less than 2⁻⁴⁸ of the largest tᵢ.
/// 2⁻⁹⁰⁰ hides what underflow takes; where corners are so near that it could take more, nothing is sure.
HWY_INLINE HWY_ATTR MayMeet may_meet(const ShearedRay& ray, const Block& block, double before) {
    constexpr double u = 0x1p-53;
    const double coarse_E = ray.coarse_E;
    MayMeet result;
    for (std::size_t at = 0; at < fan_out; at += Doubles::count()) {
        const ShearedCorner A(ray, block.A, at), B(ray, block.B, at), C(ray, block.C, at);
        const Doubles a = B.x * C.y - B.y * C.x, b = C.x * A.y - C.y * A.x, c = A.x * B.y - A.y * B.x;
        const Doubles least = min(min(a, b), c), most = max(max(a, b), c);
        if (none(!((most > coarse_E) & (least < -coarse_E)))) continue;

        const Doubles m = max(max(A.size, B.size), C.size);
        const Doubles E = side_error(m, ray.start_error);
        const auto outside = (most > E) & (least < -E);
        const Doubles F = std::abs(ray.per_D_z) * (4 * u * m + 2 * ray.start_error);
        const Doubles t_A = A.z * ray.per_D_z, t_B = B.z * ray.per_D_z, t_C = C.z * ray.per_D_z;
        const Doubles nearest = min(min(t_A, t_B), t_C), farthest = max(max(t_A, t_B), t_C);
        const Doubles sum = a + b + c, per_sum = 1.0 / sum;
        const Doubles middle = (a * t_A + b * t_B + c * t_C) * per_sum;
        const Doubles off =
            6 * E * (farthest - nearest + 2 * F) * abs(per_sum) + F + 0x1p-48 * max(abs(nearest), abs(farthest));
        const auto one_sign = (max(least, -most) > E) & (abs(sum) > 7 * E) & (m > 0x1p-150);
        constexpr double wider = 1 + 0x1p-40;  // for the bounds' own rounding
        const Doubles t_low = select(one_sign, middle - off * wider, nearest - F * wider),
                      t_high = select(one_sign, middle + off * wider, farthest + F * wider);
        t_low.store(result.low + at);
        t_high.store(result.high + at);
        const auto behind = (t_high < ray.from) | (t_low > before);
        result.sure |= bits_of(one_sign & (t_low > ray.from)) << at;
        result.some |= bits_of(!(outside | behind)) << at;
    }
    result.some &= (1u << block.count) - 1;
    return result;
}
