// A ray before a sphere, one of each in every lane: where they meet, between bounds. To be included after vectors.inl.

/// A number as doubles have it, and the most that it is off.
struct Approximate {
    Doubles value, error;

    HWY_ATTR Doubles least() const { return value - error; }
    HWY_ATTR Doubles most() const { return value + error; }
    HWY_ATTR Mask<Doubles::Tag> surely_positive() const { return value > error; }
    HWY_ATTR Mask<Doubles::Tag> surely_negative() const { return value < -error; }
};

/// How far a ray may be off: where it starts, and its direction.
struct RayError {
    double P, D;
};

/// A ray meets a sphere where D² t² + 2bt + c = 0: with v its start as seen from the centre, b = v·D, c = v² − r², and
/// Δ = b² − D²c. As in the core's Stable, Δ = D²(r² − l²): l = v − (b/D²) D leads from the centre to the middle of the
/// chord, so that of a small sphere far away nothing cancels but lengths at the sphere.
struct SphereEquation {
    Doubles per_D2, per_D;
    Approximate b, c, delta;
};

/// Each bound has three parts: rounding, the ray's own error ε, and underflow, which takes less than 2⁻¹⁰⁷⁰ from a
/// product. The factors leave room for the bounds' own rounding.
HWY_INLINE HWY_ATTR SphereEquation sphere_equation(const Vec3<Doubles>& v, const Vec3<Doubles>& D, const Doubles& r2,
                                                   const RayError& off) {
    constexpr double u = 0x1p-53;
    const Doubles D2 = dot(D, D), v2 = dot(v, v), b = dot(v, D), c = v2 - r2, per_D2 = 1 / D2;
    const Vec3<Doubles> l = v - (b * per_D2) * D;
    const Doubles l2 = dot(l, l), h = r2 - l2;
    const Doubles size_D = sqrt(D2), per_D = size_D * per_D2, size_v = sqrt(v2), size_l = sqrt(l2);

    // Rounding: 8u|v||D|, and as much again where −b and √Δ cancel. The ray: ε|v| or ε|D|.
    const Doubles b_error = 24 * u * size_v * size_D + 2 * (off.D * size_v + off.P * size_D);
    // Rounding: 8u(v² + r²). The ray: 3ε(|v| + ε), for a sphere can be smaller, and nearer, than ε. Underflow: where v²
    // or r² could be lost to it, 2⁻¹⁰⁰⁰ hides c.
    const Doubles c_error = 16 * u * (v2 + r2) + 4 * off.P * (size_v + off.P) + 0x1p-1000;
    // Rounding: v by 2u|v|; b by 3u|v||D| and 1/D² relatively by 4u, so b/D² by 8u|v|/|D|, as |b| ≤ |v||D|; its product
    // with D and the difference by u|v| each: 12u|v|. The ray: l is what of v is at right angles to D, so it is off by
    // ε as v is, and by |v| times the sine of the angle by which D is, ε/|D| at most.
    const Doubles turned = off.D * per_D, l_error = 16 * u * size_v + 1.25 * (off.P + turned * size_v);
    // l² is off by l_error (2|l| + l_error). Rounding: u r², 3u l², and of their difference once more. Underflow: as
    // for c.
    const Doubles h_error = 1.25 * l_error * (2 * size_l + l_error) + 8 * u * (r2 + l2) + 0x1p-1000;
    // Of D²h. D² is off relatively by less than 4u and 2ε/|D| + (ε/|D|)², and the product is rounded. Underflow: as for
    // h, times D², D being ordinary.
    const Doubles D2_error = 8 * u + turned * (2.5 + 1.25 * turned);
    const Doubles delta_error = D2 * (1.25 * h_error * (1 + D2_error) + D2_error * abs(h)) + 0x1p-900;
    return {per_D2, per_D, {b, b_error}, {c, c_error}, {D2 * h, delta_error}};
}

/// What one ray in each lane knows of a sphere: t is between the two where the ray surely meets it.
struct SphereRoots {
    Mask<Doubles::Tag> missed, sure;
    Doubles t_low, t_high;
};

/// From outside, c > 0, and with the sphere ahead, b < 0, it is met first at t = (−b − √Δ)/D²; from inside, c < 0, at
/// (−b + √Δ)/D², and Δ > 0. Where the bounds do not tell which, nothing is sure.
HWY_INLINE HWY_ATTR SphereRoots sphere_roots(const SphereEquation& equation, const RayError& off) {
    const auto& [per_D2, per_D, b, c, delta] = equation;
    const auto outside = c.surely_positive() & b.surely_negative(), inside = c.surely_negative();
    const auto behind = c.surely_positive() & b.surely_positive();
    const Doubles root_least = sqrt(max(delta.least(), 0.0)), root_most = sqrt(max(delta.most(), 0.0));
    // 1/D² is off relatively by 8u and by 3ε/|D|, and the product is rounded.
    const Doubles slack = 0x1p-40 + 4 * off.D * per_D;
    const Doubles t_low = (select(inside, root_least, -root_most) - b.most()) * per_D2 * (1 - slack);
    const Doubles t_high = (select(inside, root_most, -root_least) - b.least()) * per_D2 * (1 + slack);
    const auto sure = (outside & delta.surely_positive()) | inside;
    return {behind | (delta.surely_negative() & !inside), sure & (t_low > 0.0) & (slack < 0.5), t_low, t_high};
}
