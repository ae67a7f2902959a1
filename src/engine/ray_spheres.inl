// A leaf's spheres before a single ray: which it may meet, and between which t. To be included after ray_triangles.inl
// and sphere_roots.inl.

/// Of `count` spheres, eight at most, those that the ray may meet at a t of `before` or less.
HWY_INLINE HWY_ATTR MayMeet may_meet(const glassbox::Ray<double>& ray, const glassbox::Sphere<double>* spheres,
                                     const std::uint32_t* numbers, std::uint32_t count, double before) {
    alignas(64) double C[3][fan_out], r[fan_out];
    for (std::uint32_t at = 0; at < fan_out; ++at) {
        const glassbox::Sphere<double>& sphere = spheres[numbers[std::min(at, count - 1)]];
        C[0][at] = sphere.C.x;
        C[1][at] = sphere.C.y;
        C[2][at] = sphere.C.z;
        r[at] = sphere.r;
    }
    const Vec3<Doubles> P = broadcast(ray.P), D = broadcast(ray.D);
    constexpr RayError none{0, 0};
    MayMeet result;
    for (std::size_t at = 0; at < fan_out; at += Doubles::count()) {
        const Doubles radius = Doubles::load(r + at);
        const SphereRoots roots =
            sphere_roots(sphere_equation(P - load(C, at), D, radius * radius, none), none);
        select(roots.sure, roots.t_low, 0.0).store(result.low + at);  // else the bounds are not sure, either
        roots.t_high.store(result.high + at);
        const auto behind = roots.sure & (roots.t_low > before);
        result.sure |= bits_of(roots.sure) << at;
        result.some |= bits_of(!(roots.missed | behind)) << at;
    }
    result.some &= (1u << count) - 1;
    return result;
}
