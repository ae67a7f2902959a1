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

/// What all rays of a tile know of a sphere: which may meet it, and which surely do (1, else 0), and between which
/// keys.
struct SphereKeys {
    alignas(64) float low[tile_size], high[tile_size], live[tile_size], sure[tile_size];
};

/// By doubles. `middle` is the tile's middle ray.
HWY_INLINE HWY_ATTR SphereKeys sphere_keys(const Grid& grid, const glassbox::Ray<double>& middle,
                                           const glassbox::Sphere<double>& sphere) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    const RayError off = ray_error(grid);
    const Vec3<Doubles> from = broadcast(middle.P - sphere.C), direction = broadcast(middle.D);
    const Doubles r2 = sphere.r * sphere.r;
    SphereKeys keys;
    for (std::size_t i = 0; i < tile_size; i += Doubles::count()) {
        const Doubles dj = load_as_doubles(offsets.right + i), di = load_as_doubles(offsets.up + i);
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
