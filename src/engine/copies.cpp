#include "engine/copies.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <tuple>

namespace glassbox::engine {

namespace {

std::uint64_t mixed(std::uint64_t x) {
    x *= 0x9E37'79B9'7F4A'7C15;
    return x ^ (x >> 29);
}
std::uint64_t hash(double x) { return std::bit_cast<std::uint64_t>(x + 0.0); }  // 0 for −0, which equals it
std::uint64_t hash(const Vec3<double>& v) { return mixed(mixed(mixed(hash(v.x)) + hash(v.y)) + hash(v.z)); }
std::uint64_t hash(const Sphere<double>& s) { return mixed(hash(s.C) + hash(s.r)); }
/// The same in whatever order the corners are.
std::uint64_t hash(const Triangle<double>& t) { return mixed(hash(t.A) + hash(t.B) + hash(t.C)); }

/// Which hashes were seen, by a few of their bits: never that one was not which was.
class Seen {
public:
    explicit Seen(std::size_t count) : bits_(std::bit_ceil(count / 4 + 1)) {}

    bool has(std::uint64_t hash) const { return (word(hash) & bit(hash)) != 0; }
    void add(std::uint64_t hash) { bits_[place(hash)] |= bit(hash); }

private:
    std::size_t place(std::uint64_t hash) const { return (hash >> 6) & (bits_.size() - 1); }
    std::uint64_t word(std::uint64_t hash) const { return bits_[place(hash)]; }
    static std::uint64_t bit(std::uint64_t hash) { return std::uint64_t{1} << (hash & 63); }

    std::vector<std::uint64_t> bits_;
};

bool are_same(const Sphere<double>& a, const Sphere<double>& b) { return a.C == b.C && a.r == b.r; }

bool are_same(const Triangle<double>& a, const Triangle<double>& b) {
    const auto in_order = [](const Triangle<double>& t) {
        std::tuple<double, double, double> corners[] = {
            {t.A.x, t.A.y, t.A.z}, {t.B.x, t.B.y, t.B.z}, {t.C.x, t.C.y, t.C.z}};
        std::ranges::sort(corners);
        return std::to_array(corners);
    };
    return in_order(a) == in_order(b);
}

}  // namespace

std::vector<Copy> take_out_copies(std::vector<Boxed>& surfaces, std::span<const Sphere<double>> spheres,
                                  std::span<const Triangle<double>> triangles) {
    // Most scenes have none, so a look at a few bits of each surface's hash must tell that.
    std::vector<std::uint64_t> hashes(surfaces.size());
    std::ranges::transform(surfaces, hashes.begin(), [&](const Boxed& one) {
        return one.is_sphere ? hash(spheres[one.surface]) : hash(triangles[one.surface - spheres.size()]);
    });
    Seen once(surfaces.size());
    std::vector<std::uint64_t> twice;
    for (const std::uint64_t its : hashes) {
        if (once.has(its)) twice.push_back(its);
        once.add(its);
    }
    if (twice.empty()) return {};
    std::ranges::sort(twice);

    struct Suspect {
        std::uint64_t hash;
        Boxed one;
    };
    std::vector<Suspect> suspects;
    Seen among(surfaces.size());
    for (const std::uint64_t its : twice) among.add(its);
    for (std::size_t i = 0; i < surfaces.size(); ++i)
        if (among.has(hashes[i]) && std::ranges::binary_search(twice, hashes[i]))
            suspects.push_back({hashes[i], surfaces[i]});
    // Equal hashes together, and of these the last listed first.
    std::ranges::sort(suspects, [](const Suspect& a, const Suspect& b) {
        return a.hash != b.hash ? a.hash < b.hash : a.one.surface > b.one.surface;
    });

    const auto same = [&](const Boxed& a, const Boxed& b) {
        if (a.is_sphere != b.is_sphere) return false;
        if (a.is_sphere) return are_same(spheres[a.surface], spheres[b.surface]);
        return are_same(triangles[a.surface - spheres.size()], triangles[b.surface - spheres.size()]);
    };
    std::vector<Copy> copies;
    std::vector<Boxed> originals;  // of one hash
    for (std::size_t i = 0; i < suspects.size(); ++i) {
        if (i == 0 || suspects[i].hash != suspects[i - 1].hash) originals.clear();
        const Boxed& one = suspects[i].one;
        const auto found = std::ranges::find_if(originals, [&](const Boxed& other) { return same(one, other); });
        if (found != originals.end()) copies.push_back({found->surface, one.surface});
        else originals.push_back(one);
    }
    if (copies.empty()) return {};
    std::vector<std::uint32_t> gone;
    for (const Copy& copy : copies) gone.push_back(copy.surface);
    std::ranges::sort(gone);
    std::erase_if(surfaces, [&](const Boxed& one) { return std::ranges::binary_search(gone, one.surface); });
    std::sort(copies.begin(), copies.end());
    return copies;
}

}  // namespace glassbox::engine
