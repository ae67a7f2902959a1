#pragma once
#include <variant>

#include <turn.hpp>
#include <viewing_plane.hpp>

#include "numerics/enclosure.hpp"
#include "render/options.hpp"
#include "render/view.hpp"
#include "scene/scene.hpp"

namespace glassbox {

/// What may become of a scene's view in another program, however it rounds: the core's formulas in an Enclosure.
template <class Real>
class TheirView {
public:
    using Number = Enclosure<Real>;

    /// Where the view was resized, its numbers are rounded already.
    TheirView(const Scene& scene, const Options& options, bool is_resized) : height_(scene.height) {
        const auto vector = [&](const Vec3<double>& v) {
            const Vec3<Number> exact = convert<Number>(v);
            return is_resized ? Vec3<Number>{again_rounded(exact.x), again_rounded(exact.y), again_rounded(exact.z)}
                              : exact;
        };
        if (const auto* v = std::get_if<ParallelView>(&scene.view))
            view_ =
                Parallel<Number>{{vector(v->corner), vector(v->right), vector(v->up)}, convert<Number>(v->direction)};
        else {
            const auto& [eye, look_at, up, angle] = std::get<PinholeView>(scene.view);
            view_ = looking<Number>(convert<Number>(eye), convert<Number>(look_at), convert<Number>(up), Number(angle),
                                    scene.width, scene.height);
        }
        for (const Turn<double>& turn : turns_of(options)) {
            const Rotation<Number> R = rotation(Turn<Number>{turn.axis, Number(turn.degrees)});
            std::visit([&](auto& v) { v = turned(v, R, convert<Number>(scene.pivot)); }, view_);
        }
    }

    /// The ray of the pixel (x, y); y counts down.
    Ray<Number> ray(int x, int y) const {
        return std::visit([&](const auto& v) { return pixel_ray(v, Number(x), Number(height_ - 1 - y)); }, view_);
    }

private:
    /// A number that was computed in two operations.
    static Number again_rounded(const Number& number) {
        const auto& [value, error] = number.range();
        return Number(Bounded(value, Bounded::up(error + 4 * std::numeric_limits<Real>::epsilon() * std::abs(value))));
    }

    int height_;
    std::variant<Parallel<Number>, Pinhole<Number>> view_;
};

}  // namespace glassbox
