// A leaf's spheres before a single ray: which it may meet, and between which t. To be included after
// sphere_roots.inl.

/// Calls `take(at, sure, low, high)` for each of `count` spheres, eight at most, that the ray may meet, between two t;
/// `sure` says that it does. `numbers` are theirs.
template <class Take>
HWY_INLINE HWY_ATTR void for_each_met(const BoxRay& from, const glassbox::Sphere<double>* spheres,
                                      const std::uint32_t* numbers, std::uint32_t count, const Take& take) {
    alignas(64) double C[3][fan_out], r[fan_out];
    for (std::uint32_t at = 0; at < fan_out; ++at) {
        const glassbox::Sphere<double>& sphere = spheres[numbers[std::min(at, count - 1)]];
        C[0][at] = sphere.C.x;
        C[1][at] = sphere.C.y;
        C[2][at] = sphere.C.z;
        r[at] = sphere.r;
    }
    const Vec3<Doubles> P = broadcast(from.ray().P), D = broadcast(from.ray().D);
    const RayError off{2 * from.start_error, 0};
    const bool is_moved = from.shift != 0;
    const double from_the_start = -from.shift;
    std::uint32_t some = 0, surely = 0;
    alignas(64) double low[fan_out], high[fan_out];
    for (std::size_t at = 0; at < fan_out; at += Doubles::count()) {
        const Doubles radius = Doubles::load(r + at);
        const SphereEquation equation = sphere_equation(P - load(C, at), D, radius * radius, off);
        const SphereRoots roots = sphere_roots(equation, off);
        // Whether it is met is sure, but t is told by plain doubles, whose squares must neither overflow nor underflow.
        const auto ordinary = (radius > 0x1p-100) & (radius < 0x1p100);
        // A ray that was moved ahead started outside.
        const auto sure = (is_moved ? roots.sure & equation.c.surely_positive() : roots.sure) & ordinary;
        select(sure, roots.t_low, from_the_start).store(low + at);  // else the bounds are not sure, either
        roots.t_high.store(high + at);
        surely |= bits_of(sure) << at;
        some |= bits_of(!roots.missed) << at;
    }
    for (some &= (1u << count) - 1; some != 0; some &= some - 1) {
        const auto at = static_cast<std::uint32_t>(__builtin_ctz(some));
        take(at, (surely >> at & 1) != 0, low[at], high[at]);
    }
}
