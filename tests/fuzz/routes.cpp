#include "routes.hpp"

#include <fmt/format.h>
#include <hwy/highway.h>
#include <hwy/targets.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <string_view>
#include <utility>

#include "engine/kernels.hpp"
#include "render/option_names.hpp"
#include "render/render.hpp"
#include "render/search/fast_search.hpp"
#include "render/shoot.hpp"

namespace glassbox::fuzz {

namespace {

using Found = std::optional<Fault>;

/// A surface's number, or none.
using Surface = std::optional<std::size_t>;

std::string shown(const Surface& surface) { return surface ? fmt::format("surface {}", *surface) : "nothing"; }

Surface first_of(const oracle::Answer& answer) { return answer.first ? Surface(answer.first->surface) : Surface(); }

std::string shown(const Vec3<double>& v) { return fmt::format("({}, {}, {})", v.x, v.y, v.z); }
std::string shown(const Rgb& c) { return fmt::format("{} {} {}", c.red, c.green, c.blue); }

std::string shown(const oracle::Oracle& oracle, const Ray<double>& ray, const oracle::Answer& answer) {
    if (!answer.valid) return "invalid";
    if (!answer.first) return "nothing";
    std::vector<std::size_t> met;
    for (const oracle::Meeting& meeting : answer.met) met.push_back(meeting.surface);
    return fmt::format("surface {} at t = {}; met: {}", answer.first->surface,
                       oracle.t_text(to_oracle(ray), *answer.first, 20), fmt::join(met, " "));
}

Job on(const Trial& trial, int threads) {
    Job job;
    job.threads = threads;
    job.engine = trial.engine();
    return job;
}

/// Compares the surface found at each pixel with the truth. `found(pixel)` returns it.
template <class Get>
Found wrong_surface(const Trial& trial, const Get& found) {
    for (std::size_t pixel = 0; pixel < trial.pixels(); ++pixel) {
        const Surface got = found(pixel), truth = first_of(trial.pixel_answers()[pixel]);
        if (got == truth) continue;
        const auto& ray = trial.pixel_rays()[pixel];
        return Fault{!got     ? "wrong miss"
                     : !truth ? "wrong hit"
                              : "wrong surface",
                     pixel,
                     {},
                     shown(trial.oracle(), ray, trial.pixel_answers()[pixel]),
                     shown(got)};
    }
    return {};
}

/// Returns the surface that a colour of a picture without shading stands for: see to_toml.
Surface surface_of(const Rgb& color) {
    const std::size_t n = std::size_t{color.red} << 16 | std::size_t{color.green} << 8 | color.blue;
    return n == 0 ? Surface() : Surface(n - 1);
}

std::vector<Surface> surfaces_seen(const Trial& trial, Options options, int threads) {
    options.stage = 3;
    std::vector<Surface> seen;
    for (const Rgb& color : render(trial.scene(), options, on(trial, threads)).pixels)
        seen.push_back(surface_of(color));
    return seen;
}

Route picture(const std::string& name, const Options& options, int threads, const std::string& command) {
    return {name,
            [=](const Trial& trial) {
                const std::vector<Surface> seen = surfaces_seen(trial, options, threads);
                return wrong_surface(trial, [&](std::size_t pixel) { return seen[pixel]; });
            },
            "render --stage 3 " + command};
}

/// The same, with one kind of vectors.
Route with_vectors(std::int64_t target, Route route) {
    route.name += std::string(", ") + hwy::TargetName(target);
    route.check = [target, check = std::move(route.check)](const Trial& trial) {
        struct Only {
            explicit Only(std::int64_t it) { set(it); }
            ~Only() { set(0); }
            static void set(std::int64_t it) {
                hwy::SetSupportedTargetsForTest(it);
                hwy::GetChosenTarget().Update(hwy::SupportedTargets());
            }
        } const only(target);
        return check(trial);
    };
    return route;
}

/// The walk through the hierarchy for the nearest surface only, as pictures use it where tiles cannot decide.
Route walk() {
    return {"ray by ray",
            [](const Trial& trial) {
                const FastSearch search(trial.engine(), {}, {});
                return wrong_surface(trial, [&](std::size_t pixel) {
                    const Silent silent;
                    const auto hit = search.trace(trial.pixel_rays()[pixel], silent);
                    return hit ? Surface(hit->surface) : Surface();
                });
            },
            "render --stage 3"};
}

/// Shaded pictures: the same bytes with the engine and without.
Route same_bytes() {
    return {"shaded by the engine and without",
            [](const Trial& trial) -> Found {
                Options plain;
                plain.engine = EngineChoice::plain;
                const Image expected = render(trial.scene(), plain, on(trial, 1));
                const Image got = render(trial.scene(), {}, on(trial, 1));
                for (std::size_t i = 0; i < trial.pixels(); ++i)
                    if (!(expected.pixels[i] == got.pixels[i]))
                        return Fault{"other bytes", i, {}, shown(expected.pixels[i]), shown(got.pixels[i])};
                return {};
            },
            "render"};
}

std::vector<std::vector<Channel>> measured(const Trial& trial, const Options& options,
                                           std::initializer_list<std::string_view> names) {
    std::vector<const Measurement*> wanted;
    for (const std::string_view name : names) wanted.push_back(find_measurement(name));
    return measure(trial.scene(), options, wanted, on(trial, 1));
}

/// Whether this is a unit normal, and as close to the true one as its formula can be.
bool is_normal(const Vec3<double>& n, const oracle::Normal& truth) {
    if (!std::isfinite(truth.condition)) return true;  // all digits cancel
    if (!(std::abs(std::sqrt(n.x * n.x + n.y * n.y + n.z * n.z) - 1) < 0x1p-50)) return false;
    const double off = std::max({std::abs(n.x - truth.n.x), std::abs(n.y - truth.n.y), std::abs(n.z - truth.n.z)});
    return !(off > 0x1p-50 * truth.condition);
}

Fault fault(const char* kind, std::size_t pixel, const std::string& expected, const std::string& got) {
    return {kind, pixel, {}, expected, got};
}

/// The verdicts on a certified picture, and the numbers of surfaces that it counts.
Route verdicts(const std::string& name, const Options& options, const std::string& command) {
    return {name,
            [=](const Trial& trial) -> Found {
                const auto all = measured(trial, options, {"verdict", "hits"});
                for (std::size_t pixel = 0; pixel < trial.pixels(); ++pixel) {
                    if (!trial.pixel_answers()[pixel].valid) continue;
                    const std::size_t met = trial.pixel_answers()[pixel].met.size();
                    if (const double verdict = all[0][0].values[pixel]; verdict != 0)
                        return fault("wrong verdict", pixel, "0", fmt::to_string(verdict));
                    if (const double hits = all[1][0].values[pixel]; hits != static_cast<double>(met))
                        return fault("wrong count", pixel, fmt::to_string(met), fmt::to_string(hits));
                }
                return {};
            },
            "measure --what verdict,hits " + command};
}

/// Normal and depth where the right surface is met.
Route normals() {
    return {"normals",
            [](const Trial& trial) -> Found {
                const auto all = measured(trial, {}, {"normal", "depth"});
                for (std::size_t pixel = 0; pixel < trial.pixels(); ++pixel) {
                    const oracle::Answer& answer = trial.pixel_answers()[pixel];
                    const double depth = all[1][0].values[pixel];
                    if (!answer.first || std::isnan(depth)) continue;
                    const oracle::Ray ray = to_oracle(trial.pixel_rays()[pixel]);
                    const oracle::Normal truth = trial.oracle().normal(ray, *answer.first);
                    const Vec3<double> n{all[0][0].values[pixel], all[0][1].values[pixel], all[0][2].values[pixel]};
                    if (!is_normal(n, truth))
                        return fault(!is_finite(n) ? "normal not finite" : "wrong normal", pixel,
                                     shown(Vec3<double>{truth.n.x, truth.n.y, truth.n.z}), shown(n));
                    if (!(depth >= 0)) return fault("no depth", pixel, "a number above 0", fmt::to_string(depth));
                }
                return {};
            },
            "measure --what normal,depth"};
}

/// The verdicts on a plain scalar's picture, against what that picture shows.
Route judged(Scalar scalar) {
    const std::string name(name_of(scalar));
    return {"verdict of " + name,
            [=](const Trial& trial) -> Found {
                Options options;
                options.scalar = scalar;
                const std::vector<Surface> seen = surfaces_seen(trial, options, 1);
                const std::vector<double> verdicts = measured(trial, options, {"verdict"})[0][0].values;
                for (std::size_t pixel = 0; pixel < trial.pixels(); ++pixel) {
                    const oracle::Answer& answer = trial.pixel_answers()[pixel];
                    if (!answer.valid) continue;
                    const Surface truth = first_of(answer), got = seen[pixel];
                    const double verdict = got == truth ? 0 : !truth ? 1 : !got ? 2 : 3;
                    if (verdicts[pixel] != verdict)
                        return fault("wrong verdict", pixel, fmt::to_string(verdict), fmt::to_string(verdicts[pixel]));
                }
                return {};
            },
            "measure --what verdict --scalar " + name};
}

/// Returns what is wrong with a shot, if anything is.
std::string why_wrong(const oracle::Oracle& oracle, const Ray<double>& ray, const oracle::Answer& answer,
                      const Shot& shot) {
    using Verdict = Shot::Answer;
    const Verdict verdict = !answer.valid ? Verdict::invalid : answer.first ? Verdict::hit : Verdict::miss;
    if (shot.answer != verdict)
        return shot.answer == Verdict::hit ? "wrong hit" : verdict == Verdict::hit ? "wrong miss" : "wrong verdict";
    if (!answer.first) return {};
    if (shot.surface != answer.first->surface) return "wrong surface";
    if (shot.hits != answer.met.size()) return "wrong count";
    const oracle::Ray its_ray = to_oracle(ray);
    if (!oracle.is_within(its_ray, *answer.first, shot.t, shot.t_error)) return "t outside its bound";
    // t is known to nearly all the digits of a double.
    const long double t = answer.first->high;
    if (t < 0x1p1000L && !(shot.t_error <= 0x1p-46L * t + 0x1p-1020L)) return "bound on t too large";
    return {};
}

std::string shown(const Shot& shot) {
    switch (shot.answer) {
        case Shot::Answer::miss:
            return "nothing";
        case Shot::Answer::invalid:
            return "invalid";
        default:
            return fmt::format("surface {} at t = {} ± {}; {} met", shot.surface, static_cast<double>(shot.t),
                               shot.t_error, shot.hits);
    }
}

/// Shots by a rule for triangles; `truth(trial)` gives the right answers.
template <class Truth>
Route shots(const Options& options, int threads, const Truth& truth) {
    const std::string command =
        fmt::format("--engine {} --scalar {} --sphere {} --triangle {}", name_of(options.engine),
                    name_of(options.scalar), name_of(options.sphere_rule), written(options.triangle_rule));
    return {"shoot " + command + (threads > 1 ? ", 2 threads" : ""),
            [=](const Trial& trial) -> Found {
                const std::vector<Shot> all = shoot(trial.scene(), options, trial.rays(), on(trial, threads));
                const auto& [oracle, answers] = truth(trial);
                for (std::size_t i = 0; i < all.size(); ++i)
                    if (const std::string why = why_wrong(oracle, trial.rays()[i], answers[i], all[i]); !why.empty())
                        return Fault{why, {}, i, shown(oracle, trial.rays()[i], answers[i]), shown(all[i])};
                return {};
            },
            "shoot " + command};
}

using Truths = std::pair<const oracle::Oracle&, const std::vector<oracle::Answer>&>;

Truths geometry(const Trial& trial) { return {trial.oracle(), trial.answers()}; }

std::pair<oracle::Oracle, std::vector<oracle::Answer>> by_tolerance(const Trial& trial, double tolerance) {
    oracle::Oracle oracle(trial.drawn().surfaces, {tolerance});
    std::vector<oracle::Answer> answers;
    for (const Ray<double>& ray : trial.rays()) answers.push_back(oracle(to_oracle(ray)));
    return {std::move(oracle), std::move(answers)};
}

/// The pixels' rays are where the view's mathematics puts them: in the corners, and at some other pixels.
Route rays_of_the_view() {
    return {"rays of the view",
            [](const Trial& trial) -> Found {
                const auto& drawn = trial.drawn();
                const std::size_t n = trial.pixels(), width = static_cast<std::size_t>(drawn.width);
                for (const std::size_t pixel : {std::size_t{0}, width - 1, n - width, n - 1, n / 2, n / 3}) {
                    const Ray<double>& ray = trial.pixel_rays()[pixel];
                    const double error = oracle::ray_error(drawn.view, drawn.width, drawn.height, trial.x(pixel),
                                                           drawn.height - 1 - trial.y(pixel), to_oracle(ray));
                    if (!(error <= 1))
                        return Fault{"wrong ray",
                                     pixel,
                                     {},
                                     "an error of at most 1 bound",
                                     fmt::format("{} bounds, D = {}", error, shown(ray.D))};
                }
                return {};
            },
            "render"};
}

}  // namespace

std::vector<Route> all_routes() {
    std::vector<Route> routes{rays_of_the_view()};
    Options plain, fast, other;
    plain.engine = EngineChoice::plain;
    fast.engine = EngineChoice::fast;
    other.sphere_rule = Textbook{};
    other.triangle_rule = MoellerTrumbore{};
    for (const std::int64_t target : hwy::SupportedAndGeneratedTargets()) {
        routes.push_back(with_vectors(target, picture("picture", {}, 1, "")));
        routes.push_back(with_vectors(target, walk()));
    }
    routes.push_back(picture("picture, 2 threads", {}, 2, "--threads 2"));
    routes.push_back(picture("picture by other rules", other, 1, "--sphere textbook --triangle moeller-trumbore"));
    routes.push_back(picture("picture in the plain loop", plain, 1, "--engine plain"));
    routes.push_back(same_bytes());
    routes.push_back(verdicts("verdicts in the plain loop", plain, "--engine plain"));
    routes.push_back(verdicts("verdicts by the engine", fast, "--engine fast"));
    routes.push_back(normals());
    for (const Scalar scalar : {Scalar::float_, Scalar::double_, Scalar::long_double}) routes.push_back(judged(scalar));

    for (const EngineChoice engine : {EngineChoice::plain, EngineChoice::fast})
        for (const SphereRule& sphere : {SphereRule(Stable{}), SphereRule(Textbook{})})
            for (const TriangleRule& triangle : {TriangleRule(Pluecker{}), TriangleRule(MoellerTrumbore{})}) {
                Options options;
                options.engine = engine;
                options.sphere_rule = sphere;
                options.triangle_rule = triangle;
                routes.push_back(shots(options, 1, geometry));
            }
    routes.push_back(shots(fast, 2, geometry));
    Options exact;
    exact.scalar = Scalar::exact;
    routes.push_back(shots(exact, 1, geometry));
    for (const double tolerance : {10.0, 1e-12}) {
        Options options;
        options.triangle_rule = Tolerance{tolerance};
        routes.push_back(shots(options, 1, [=](const Trial& trial) { return by_tolerance(trial, tolerance); }));
    }
    return routes;
}

}  // namespace glassbox::fuzz
