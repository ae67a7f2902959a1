// Compares the answers of certified and exact shooting with integer arithmetic: no wrong verdict, surface or count;
// every t within its bound; and bounds that hold.
#include <doctest.h>

#include <algorithm>
#include <sstream>

#include "cases.hpp"
#include "oracle/of_scene.hpp"
#include "render/shoot.hpp"

using namespace glassbox;
using test::Case;

namespace {

using oracle::Answer, oracle::Oracle;
using test::to_oracle;
using Verdict = Shot::Answer;

Verdict verdict(const Answer& truth) {
    return !truth.valid ? Verdict::invalid : truth.first ? Verdict::hit : Verdict::miss;
}

std::string shown(Verdict verdict) {
    return verdict == Verdict::hit ? "hit" : verdict == Verdict::miss ? "miss" : "invalid";
}

std::string shown(const Ray<double>& ray) {
    std::ostringstream out;
    out << std::hexfloat << ray.P.x << "," << ray.P.y << "," << ray.P.z << "," << ray.D.x << "," << ray.D.y << ","
        << ray.D.z;
    return out.str();
}

std::string shown(const Oracle& oracle, const Ray<double>& ray, const Answer& truth) {
    std::ostringstream out;
    out << shown(verdict(truth));
    if (!truth.first) return out.str();
    out << " of " << truth.first->surface << " at t = " << oracle.t_text(to_oracle(ray), *truth.first, 25) << ", meets "
        << truth.met.size() << ":";
    for (const oracle::Meeting& meeting : truth.met) out << " " << meeting.surface;
    return out.str();
}

std::string shown(const Shot& shot) {
    std::ostringstream out;
    out << shown(shot.answer);
    if (shot.answer != Verdict::hit) return out.str();
    out.precision(25);
    out << " of " << shot.surface << " at t = " << shot.t << " ± " << shot.t_error << ", meets " << shot.hits
        << (shot.by_filter ? ", by filter" : ", exactly");
    return out.str();
}

/// What many shots got wrong, and how accurate their t are.
struct Tally {
    int rays = 0, hits = 0, exactly = 0;
    int wrong_verdicts = 0, wrong_surfaces = 0, wrong_counts = 0, broken_bounds = 0;
    double worst_t = 0;  ///< the largest relative error of t
    std::string worst_ray;
    std::vector<double> looseness;  ///< t_error over the true error

    int wrong() const { return wrong_verdicts + wrong_surfaces + wrong_counts; }

    double median_looseness() {
        if (looseness.empty()) return 0;
        const auto middle = looseness.begin() + static_cast<std::ptrdiff_t>(looseness.size() / 2);
        std::nth_element(looseness.begin(), middle, looseness.end());
        return *middle;
    }
};

/// Whether a double can hold a t of this size with all its digits.
bool is_ordinary(long double t) {
    return t > std::numeric_limits<double>::min() && t < std::numeric_limits<double>::max();
}

/// Judges one shot; returns false if anything is wrong. `proven` shots know their error.
bool judge(Tally& tally, const Oracle& oracle, const Ray<double>& ray, const Answer& truth, const Shot& shot,
           bool proven) {
    const int before = tally.wrong() + tally.broken_bounds;
    const auto is_right = [&] { return before == tally.wrong() + tally.broken_bounds; };
    ++tally.rays;
    tally.exactly += truth.valid && !shot.by_filter;
    if (shot.answer != verdict(truth)) ++tally.wrong_verdicts;
    else if (truth.first && shot.surface != truth.first->surface) ++tally.wrong_surfaces;
    if (shot.hits != truth.met.size()) ++tally.wrong_counts;
    if (!proven || !truth.first || shot.answer != Verdict::hit) return is_right();

    ++tally.hits;
    const oracle::Ray its_ray = to_oracle(ray);
    const long double t = truth.first->high;
    if (!oracle.is_within(its_ray, *truth.first, shot.t, shot.t_error)) ++tally.broken_bounds;
    if (!is_ordinary(t)) return is_right();
    const long double error = oracle.error_of(its_ray, *truth.first, shot.t);
    const auto relative = static_cast<double>(error / t);
    if (!(relative <= tally.worst_t)) {
        tally.worst_t = relative;
        tally.worst_ray = shown(ray);
    }
    if (error > 0) tally.looseness.push_back(static_cast<double>(shot.t_error / error));
    return is_right();
}

std::vector<Shot> shoot_in(const Case& c, const Options& options, std::span<const Ray<double>> rays) {
    Job job;
    job.threads = 1;
    return shoot(c.scene, options, rays, job);
}

Options in(Scalar scalar, const SphereRule& rule = Stable{}) {
    Options options;
    options.scalar = scalar;
    options.sphere_rule = rule;
    return options;
}

/// The results of all requests about one set of cases.
struct Results {
    Tally certified, one_by_one, textbook, exact, plain;

    void add(const Case& c) {
        const Oracle oracle(test::surfaces_of(c.scene));
        const std::vector<Shot> together = shoot_in(c, in(Scalar::certified), c.rays);
        const std::vector<Shot> in_double = shoot_in(c, in(Scalar::double_), c.rays);
        for (std::size_t i = 0; i < c.rays.size(); ++i) {
            const Ray<double>& ray = c.rays[i];
            const Answer truth = oracle(to_oracle(ray));
            judge(plain, oracle, ray, truth, in_double[i], false);
            told(c, oracle, ray, truth, together[i], judge(certified, oracle, ray, truth, together[i], true));
            const auto alone = [&](Tally& tally, const Options& options) {
                const Shot shot = shoot_in(c, options, {&ray, 1}).at(0);
                told(c, oracle, ray, truth, shot, judge(tally, oracle, ray, truth, shot, true));
            };
            // A filter that covers only this one ray is the tightest.
            if (i % 8 == 3) alone(one_by_one, in(Scalar::certified));
            if (i % 32 == 5) alone(exact, in(Scalar::exact));
            if (i % 16 == 7 && !c.scene.spheres.empty()) alone(textbook, in(Scalar::certified, Textbook{}));
        }
    }

private:
    int told_ = 0;

    void told(const Case& c, const Oracle& oracle, const Ray<double>& ray, const Answer& truth, const Shot& shot,
              bool is_right) {
        if (is_right || ++told_ > 5) return;
        MESSAGE(c.name << "\n  ray      " << shown(ray) << "\n  expected " << shown(oracle, ray, truth)
                       << "\n  got      " << shown(shot));
    }
};

/// Checks all that is promised; returns how many answers plain double gets wrong.
int check(const std::vector<Case>& cases) {
    Results results;
    for (const Case& c : cases) results.add(c);
    for (Tally* tally : {&results.certified, &results.one_by_one, &results.textbook, &results.exact}) {
        CHECK(tally->wrong_verdicts == 0);
        CHECK(tally->wrong_surfaces == 0);
        CHECK(tally->wrong_counts == 0);
        CHECK(tally->broken_bounds == 0);
        CHECK(tally->median_looseness() <= 64);
        CHECK_MESSAGE(tally->worst_t < 0x1p-48, tally->worst_t << " of t, at " << tally->worst_ray);
    }
    Tally& good = results.certified;
    const Tally& plain = results.plain;
    MESSAGE(good.rays << " rays in " << cases.size() << " scenes, " << good.hits << " hits, " << good.exactly
                      << " undecided by bounds; t wrong by 2^" << std::log2(good.worst_t)
                      << " of it at most, its bound is " << good.median_looseness()
                      << " times the true error in the median. Plain double: " << plain.wrong_verdicts
                      << " wrong verdicts, " << plain.wrong_surfaces << " wrong surfaces, " << plain.wrong_counts
                      << " wrong counts");
    CHECK(good.hits > good.rays / 10);
    return plain.wrong();
}

/// The same for hard cases: if plain double got them right, they would prove nothing.
void check_hard(const std::vector<Case>& cases) { CHECK(check(cases) > 0); }

}  // namespace

TEST_CASE("through vertices and edges of meshes, at all scales and distances from the origin") {
    check(test::meshes());
}
TEST_CASE("starts one ulp apart") { check_hard(test::grids()); }
TEST_CASE("surfaces at the same distance") { check_hard(test::ties()); }
TEST_CASE("triangles of nearly no area") { check_hard(test::slivers()); }
TEST_CASE("spheres, far, grazed, huge and tiny") { check_hard(test::spheres()); }
TEST_CASE("sizes whose products overflow and underflow") { check_hard(test::magnitudes()); }
TEST_CASE("all sizes at once") { check_hard({test::all_sizes()}); }
TEST_CASE("nothing special") { check({test::anything()}); }
