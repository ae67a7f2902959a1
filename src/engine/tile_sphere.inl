// A sphere before a tile's rays: where each of them meets it, between bounds. To be included after sphere_roots.inl.

/// How far a tile's rays may be off: in a pinhole's view their directions, else where they start.
inline RayError ray_error(const Grid& grid) {
    return grid.pinhole ? RayError{0, grid.ray_error} : RayError{grid.ray_error, 0};
}

/// The keys of two t, the nearer first, so far outwards that rounding to floats keeps them outside.
struct SphereKeyRange {
    Doubles nearest, farthest;
};

HWY_INLINE HWY_ATTR SphereKeyRange sphere_key_range(const Grid& grid, const Doubles& t_low, const Doubles& t_high) {
    constexpr double wide = 1 + 0x1p-20, narrow = 1 - 0x1p-20;
    if (grid.pinhole) return {grid.key_of_t * wide / t_low, grid.key_of_t * narrow / t_high};
    return {-(grid.key_of_t * t_low * narrow), -(grid.key_of_t * t_high * wide)};
}

/// What the rays of a part know of a sphere: which may meet it, and which surely do (1, else 0), and between which
/// keys.
struct SphereKeys {
    alignas(64) float low[part_size], high[part_size], live[part_size], sure[part_size];
};

/// By doubles. `middle` is the tile's middle ray; the part's rays begin at the place `begin`.
HWY_INLINE HWY_ATTR SphereKeys sphere_keys(const Grid& grid, const glassbox::Ray<double>& middle,
                                           const glassbox::Sphere<double>& sphere, std::size_t begin) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    const RayError off = ray_error(grid);
    const Vec3<Doubles> from = broadcast(middle.P - sphere.C), direction = broadcast(middle.D);
    const Doubles r2 = sphere.r * sphere.r;
    SphereKeys keys;
    for (std::size_t i = 0; i < part_size; i += Doubles::count()) {
        const Doubles dj = load_as_doubles(offsets.right + begin + i), di = load_as_doubles(offsets.up + begin + i);
        const Vec3<Doubles> step = {dj * grid.right.x + di * grid.up.x, dj * grid.right.y + di * grid.up.y,
                                    dj * grid.right.z + di * grid.up.z};
        const Vec3<Doubles> D = grid.pinhole ? direction + step : direction;
        const Vec3<Doubles> v = grid.pinhole ? from : from + step;
        const SphereRoots roots = sphere_roots(sphere_equation(v, D, r2, off), off);
        const auto [nearest, farthest] = sphere_key_range(grid, roots.t_low, roots.t_high);
        const auto mark = [](const Mask<Doubles::Tag>& mask)
                              HWY_ATTR { return select(mask, Doubles(1.0), Doubles(0.0)); };
        store_as_floats(select(roots.sure, nearest, infinity), keys.high + i);
        store_as_floats(select(roots.sure, farthest, -infinity), keys.low + i);
        store_as_floats(mark(!roots.missed), keys.live + i);
        store_as_floats(mark(roots.sure & !roots.missed), keys.sure + i);
    }
    return keys;
}

/// A sphere before a pinhole tile's rays, in floats and for a first look: it passes over spheres that are missed, or
/// behind all that was met, without a root or a division. With lengths in units of the grid's distance,
/// directions by its direction_scale, and a key k = 1/t, what is
///
///   f = ck² + 2bk + D² = (D²t² + 2bt + c)/t²
///
/// tells on which side of the sphere's roots a t lies, and b² − cD² if there are any. b is linear in dj and di.
struct QuickSphere {
    float c, b2, b2_right, b2_up;  ///< 2b, and how it changes
    float error, error_of_key2;    ///< f is off by `error` and k² times the other at most
    float delta_error;             ///< b² − cD² is off by that at most
    bool outside;                  ///< else the rays start inside, surely
};

/// The most that a direction's terms add up to in a tile.
HWY_INLINE double longest_direction(const Grid& grid, const glassbox::Ray<double>& middle) {
    return grid.direction_scale * (length(middle.D) + half_tile * (length(grid.right) + length(grid.up)));
}

/// Of a pinhole's view; nothing where that is not sure, or floats might overflow.
///
/// With V = |v|, S = V² + r² ≥ |c|, G the longest direction, and u = 2⁻²⁴: in floats 2b is off by 8uVG, four roundings
/// of terms whose sizes add up to 2VG; ck + 2b by 3.1uSk more and 2uVG; its product with k and the sum with D² ≤ G²,
/// itself rounded, by 2u(Sk² + 2VGk) + 3.1uG² more. With 2VGk ≤ Sk² + G² that is no more than u(12.1Sk² + 10.1G²); so
/// for bk + D², which has fewer terms. The bound is 16u(Sk² + G²): what doubles lost before, the ray's own error, ε <
/// 24·2⁻⁵³ along its direction and 2ε(Vk + G) in f, and what underflow takes are nothing beside the rest, G being 2⁻²⁰
/// or more. Where floats overflow, so does the bound.
///
/// b is off by 4uVG, so b², rounded, by 9.1uV²G²; cD² by 3.1uSG²; their difference is rounded by 2uSG²: less than half
/// of 32uSG², which leaves as much for what doubles lost, and for underflow, S being 2⁻⁶⁰ or more.
HWY_INLINE HWY_ATTR std::optional<QuickSphere> quick_sphere(const Grid& grid, const glassbox::Ray<double>& middle,
                                                            const glassbox::Sphere<double>& sphere, double G) {
    using glassbox::dot;
    const double by = 1 / grid.distance, by_D = grid.direction_scale;
    const glassbox::Vec3<double> v = by * (middle.P - sphere.C);
    const double r = by * sphere.r, v2 = dot(v, v), S = v2 + r * r, c = v2 - r * r;
    if (!(S > 0x1p-60 && S < 0x1p40 && std::abs(c) > 0x1p-40 * S && G > 0x1p-20)) return {};
    constexpr double bound = 0x1p-20 * (1 + 0x1p-10);
    return QuickSphere{static_cast<float>(c),
                       static_cast<float>(2 * by_D * dot(v, middle.D)),
                       static_cast<float>(2 * by_D * dot(v, grid.right)),
                       static_cast<float>(2 * by_D * dot(v, grid.up)),
                       static_cast<float>(bound * G * G),
                       static_cast<float>(bound * S),
                       static_cast<float>(2 * bound * S * G * G),
                       c > 0};
}

/// Whether rays surely miss a sphere, or meet it behind what they meet at a key. From outside: f > 0 and t before the
/// middle of the chord, bk + D² < 0, so before the first root. From inside, where f < 0 from the ray's start to the
/// root: f < 0.
template <class Floats>
HWY_INLINE HWY_ATTR Mask<typename Floats::Tag> missed_or_behind(const QuickSphere& sphere, const Floats& dj,
                                                                const Floats& di, const Floats& D2, const Floats& key) {
    const Floats b2 = multiply_add(di, sphere.b2_up, multiply_add(dj, sphere.b2_right, sphere.b2)), b = 0.5f * b2;
    const Floats f = multiply_add(multiply_add(key, sphere.c, b2), key, D2);
    const Floats error = multiply_add(key * key, sphere.error_of_key2, sphere.error);
    if (!sphere.outside) return f < -error;
    const auto missed = b * b - sphere.c * D2 < -sphere.delta_error;
    return missed | ((f > error) & (multiply_add(b, key, D2) < -error));
}
