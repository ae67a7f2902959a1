#include "compare/compare_pictures.hpp"

#include <algorithm>
#include <cstdlib>
#include <iterator>
#include <utility>

#include "compare/precision.hpp"
#include "compare/their_shading.hpp"
#include "compare/their_view.hpp"
#include "render/lighting.hpp"
#include "render/parallel.hpp"
#include "render/render.hpp"
#include "render/search/surfaces.hpp"
#include "render/search/with_search.hpp"
#include "render/tracer.hpp"

namespace glassbox {

namespace {

int greatest_difference(const Rgb& a, const Rgb& b) {
    const auto off = [](int x, int y) { return std::abs(x - y); };
    return std::max({off(a.red, b.red), off(a.green, b.green), off(a.blue, b.blue)});
}

/// What a program may make of a number of that range as a byte: rounded or cut, after each of `cuts` terms.
Kleene may_be_byte(const Bounded& range, int cuts, std::uint8_t byte) {
    if (!is_known(range)) return Kleene::undecided();
    const double error = Bounded::up(range.error + Bounded::u * std::abs(range.value));
    const double least = std::min(range.value - error, 255.0) - cuts, most = std::max(range.value + error, 0.0) + 1;
    return byte > least && byte < most;
}

/// The colours that surfaces may be given, in the precision Real.
template <class Real>
class TheirColors {
public:
    using Number = Enclosure<Real>;

    TheirColors(const Scene& scene, const Options& options) : own_(surface_colors(scene)), stage_(options.stage) {
        const auto [L, I, shading] = lighting<Real>(scene);
        light_ = directional_light(convert<Number>(L), Number(I));
        shading_ = convert<Number>(shading);
    }

    /// Whether that surface may have that colour where the ray meets it.
    Kleene may_be(const Ray<Number>& ray, const engine::Engine& surfaces, std::size_t surface, const Possible& test,
                  const Rgb& color) const {
        if (stage_ < 4) return greatest_difference(own_[surface], color) <= 1;
        const Bounded t(test.least_t / 2 + test.most_t / 2, Bounded::up(test.most_t / 2 - test.least_t / 2));
        const Vec3<Number> computed = surfaces.with_surface(surface, [&]<class Shape>(const Shape& shape) {
            if constexpr (std::is_same_v<Shape, Sphere<double>>)
                return normal(convert<Number>(shape), at(ray, Number(t)));
            else return normal(convert<Number>(shape));
        });
        // Where rounding leaves nothing of the normal's direction, it may be any; where numbers overflow, nothing is
        // known.
        const Vec3<Number> n = test.has_bounds ? within_unit(computed) : computed;
        const Silent silent;
        const Terms<Number> terms =
            shade_by_model(n, unit(-ray.D), to_vec3<Number>(own_[surface]), light_, shading_, silent);
        const Vec3<Number> sum = terms.ambient + terms.diffuse + terms.specular;
        const int cuts = shading_.model == ShadingModel::levental_2014 ? 3 : 1;
        return may_be_byte(sum.x.range(), cuts, color.red) & may_be_byte(sum.y.range(), cuts, color.green) &
               may_be_byte(sum.z.range(), cuts, color.blue);
    }

private:
    std::vector<Rgb> own_;
    int stage_;
    Light<Number> light_;
    Shading<Number> shading_;
};

/// Judges one pixel after the other, by what may become of it in the precision Real.
template <class Real, class Search>
class PixelJudge {
public:
    PixelJudge(const Scene& scene, bool is_resized, const Options& options, const Search& search,
               const engine::Engine& surfaces, const Formulas& formulas)
        : scene_(scene),
          view_(view(scene, options)),
          search_(search),
          surfaces_(surfaces),
          formulas_(formulas),
          colors_(scene, options),
          their_view_(scene, options, is_resized),
          stage_(options.stage) {}

    /// Fills in what a difference comes from.
    void judge(PixelDifference& one) const {
        const auto [x, y] = one.pixel;
        const bool is_border = scene_.border && (x == 0 || y == 0 || x == scene_.width - 1 || y == scene_.height - 1);
        if (stage_ == 1 || is_border) {
            one.seen = is_border ? Seen::border : one.off <= 1 ? Seen::color : Seen::shading;
            one.cause = one.seen == Seen::color ? Cause::rounding : Cause::mistake;
            return;
        }
        const Ray<double> ray = pixel_ray(view_, x, y, scene_.height);
        const Ray<Enclosure<Real>> theirs = their_view_.ray(x, y);
        const std::vector<TrueHit> hits = is_valid(ray) ? true_hits(search_, ray) : std::vector<TrueHit>{};
        if (!hits.empty()) {
            const std::size_t nearest = hits.front().surface;
            one.truth = Hit<double>{nearest, true_t_of(search_, ray, nearest)};
        }
        Found best{Cause::mistake, {}, {}};
        if (one.truth) consider(best, theirs, hits, one.truth->surface, one.theirs);  // the likeliest first
        for (std::size_t surface = 0; surface < surfaces_.size() && best.cause > Cause::rounding; ++surface)
            consider(best, theirs, hits, surface, one.theirs);
        if (best.cause > Cause::rounding && is_background(one.theirs))
            best = std::min(best, Found{sight(theirs, surfaces_, hits, {}, formulas_), {}});
        one.cause = best.cause;
        one.surface = best.surface;
        one.calls = std::move(best.calls);
        if (best.cause == Cause::mistake) return tell_mistake(one, theirs, hits);
        const bool is_true_surface = best.surface && one.truth && *best.surface == one.truth->surface;
        one.seen = best.cause == Cause::tie                           ? Seen::tie
                   : is_true_surface || (!best.surface && !one.truth) ? Seen::color
                                                                      : Seen::neighbour;
    }

private:
    using TheirRay = Ray<Enclosure<Real>>;

    /// What may be seen, and what has to come out otherwise for it.
    struct Found {
        Cause cause = Cause::mistake;
        std::optional<std::size_t> surface;
        std::vector<CloseCall> calls;

        Found(Cause its_cause, std::optional<std::size_t> its_surface, std::vector<CloseCall> its_calls)
            : cause(its_cause), surface(its_surface), calls(std::move(its_calls)) {}
        Found(const Sight& sight, std::optional<std::size_t> its_surface)
            : Found(sight.cause(), its_surface, sight.calls) {}
        friend bool operator<(const Found& a, const Found& b) { return a.cause < b.cause; }
    };

    /// Takes a surface for what they see, if rounding may show it, and in their colour.
    void consider(Found& best, const TheirRay& ray, const std::vector<TrueHit>& hits, std::size_t surface,
                  const Rgb& color) const {
        const bool is_met = std::ranges::any_of(hits, [&](const TrueHit& hit) { return hit.surface == surface; });
        if (!is_met && !possible(ray, surfaces_, surface, false, formulas_).may_be_met()) return;
        const Sight seen = sight(ray, surfaces_, hits, surface, formulas_);
        if (is_beyond_rounding(seen.cause()) && seen.cause() >= best.cause) return;
        const Kleene fits = colors_.may_be(ray, surfaces_, surface, *seen.seen, color);
        if (!possibly(fits)) return;
        Found found(seen, surface);
        if (!surely(fits)) found.cause = std::max(found.cause, Cause::unknown);
        const auto met = std::ranges::find(hits, surface, &TrueHit::surface);
        const bool is_tie = met != hits.end() && met != hits.begin() && met->as_near;
        if (is_tie && found.cause == Cause::rounding) found.cause = Cause::tie;
        best = std::min(best, found);
    }

    /// Whose colour they show, where no rounding explains that they do.
    void tell_mistake(PixelDifference& one, const TheirRay& ray, const std::vector<TrueHit>& hits) const {
        one.seen = hits.empty() ? Seen::nothing : Seen::shading;
        if (!hits.empty()) one.calls = sight(ray, surfaces_, {hits.front()}, {}, formulas_).calls;
        if (is_background(one.theirs) && !hits.empty()) {
            one.seen = Seen::background;
            return;
        }
        for (const TrueHit& hit : hits) {
            const Possible test = possible(ray, surfaces_, hit.surface, true, formulas_);
            if (!surely(colors_.may_be(ray, surfaces_, hit.surface, test, one.theirs))) continue;
            one.seen = Seen::behind;
            one.surface = hit.surface;
            return;
        }
    }

    bool is_background(const Rgb& color) const { return greatest_difference(color, scene_.background) <= 1; }

    const Scene& scene_;
    View view_;
    const Search& search_;
    const engine::Engine& surfaces_;
    const Formulas& formulas_;
    TheirColors<Real> colors_;
    TheirView<Real> their_view_;
    int stage_;
};

/// All pixels that differ, in reading order.
std::vector<PixelDifference> differing(const Image& theirs, const Image& ours) {
    std::vector<PixelDifference> all;
    for (int y = 0; y < ours.height; ++y)
        for (int x = 0; x < ours.width; ++x)
            if (theirs.at(x, y) != ours.at(x, y))
                all.push_back({.pixel = {x, y},
                               .theirs = theirs.at(x, y),
                               .ours = ours.at(x, y),
                               .off = greatest_difference(theirs.at(x, y), ours.at(x, y)),
                               .truth = {},
                               .surface = {},
                               .calls = {}});
    return all;
}

struct Spread {
    std::vector<PixelDifference> some, others;
};

/// Parts the differences into every k-th one, so that there are about `most` of them, and the others.
Spread spread(std::vector<PixelDifference> all, std::size_t most) {
    const std::size_t step = (all.size() + most - 1) / most;
    if (step <= 1) return {std::move(all), {}};
    Spread parts;
    for (std::size_t i = 0; i < all.size(); ++i)
        (i % step == 0 ? parts.some : parts.others).push_back(std::move(all[i]));
    return parts;
}

}  // namespace

std::size_t PictureComparison::count(Cause cause) const {
    return static_cast<std::size_t>(std::ranges::count(looked_into, cause, &PixelDifference::cause));
}

std::size_t PictureComparison::count(Seen seen, Cause cause) const {
    return static_cast<std::size_t>(std::ranges::count_if(
        looked_into, [&](const PixelDifference& one) { return one.seen == seen && one.cause == cause; }));
}

PictureComparison compare_pictures(const Scene& scene, bool is_resized, const Options& options, const Image& picture,
                                   const Theirs& theirs, const Job& job) {
    // So many tests of a surface take some seconds.
    constexpr std::size_t enough_tests = 500'000;
    Job ours = job;
    if (!ours.engine) ours.engine = build_engine(scene, options.stage, job.threads);
    PictureComparison result{.ours = render(scene, options, ours), .looked_into = {}, .explanations = {}};
    std::vector<PixelDifference> all = differing(picture, result.ours);
    result.differ = all.size();
    for (const PixelDifference& one : all) {
        result.greatest = std::max(result.greatest, one.off);
        result.mean += one.off / static_cast<double>(all.size());
    }
    if (all.empty()) return result;
    result.explanations =
        explanations(scene, options, picture, result.ours, all.size(), {job.threads, job.stop, nullptr, ours.engine});

    const View seen = view(scene, options);
    Options proven = options;
    if (engine_can(proven)) proven.engine = EngineChoice::fast;
    const std::size_t most = std::max<std::size_t>(200, enough_tests / std::max<std::size_t>(ours.engine->size(), 1));
    Spread parts = spread(std::move(all), most);
    // Pictures that are rendered besides do not count; looking into pixels does, as much as rendering them all.
    const auto worth = static_cast<std::int64_t>(result.ours.pixels.size() / parts.some.size());
    std::atomic<std::int64_t>* const done = std::exchange(ours.done, nullptr);
    with_search<AllMet>(
        scene, proven, reach(seen, scene.width, scene.height), ours, [&]<class Search>(const Search& search) {
            if constexpr (requires { search.predicates(); })
                with_precision(theirs.precision, [&]<class Real>(std::type_identity<Real>) {
                    const PixelJudge<Real, Search> judge(scene, is_resized, options, search, *ours.engine,
                                                         theirs.formulas);
                    const auto judge_all = [&](std::vector<PixelDifference>& pixels) {
                        for_each_index(pixels.size(), ours, [&](std::size_t i) {
                            judge.judge(pixels[i]);
                            if (done && &pixels == &parts.some) *done += worth;
                        });
                    };
                    judge_all(parts.some);
                    result.looked_into = std::move(parts.some);
                    const bool has_mistake =
                        std::ranges::any_of(result.looked_into, is_beyond_rounding, &PixelDifference::cause);
                    if (has_mistake || parts.others.empty()) return;
                    // That rounding explains all can be said only of all.
                    judge_all(parts.others);
                    std::ranges::move(parts.others, std::back_inserter(result.looked_into));
                });
        });
    std::ranges::sort(result.looked_into, {},
                      [](const PixelDifference& one) { return std::pair(one.pixel.y, one.pixel.x); });
    return result;
}

}  // namespace glassbox
