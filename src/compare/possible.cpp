#include "compare/possible.hpp"

#include <algorithm>
#include <limits>
#include <optional>

#include "render/option_names.hpp"

namespace glassbox {

namespace {

/// The probe that keeps the numbers that decide.
template <class Real>
struct Deciders {
    using Number = Enclosure<Real>;

    std::vector<Decider> numbers;

    template <class What, class... Values>
    void operator()(What, const Values&...) {}

    void operator()(told::Discriminant, const Number& delta) { numbers = {named("Δ", delta)}; }
    void operator()(told::Sides, const Number& a, const Number& b, const Number& c) {
        numbers = {named("side product a", a), named("side product b", b), named("side product c", c)};
    }

    static Decider named(const char* what, const Number& number) {
        return {what, number.range().value, number.range().error};
    }
    bool are_known() const {
        return std::ranges::all_of(numbers, [](const Decider& d) { return is_known(Bounded(d.value, d.error)); });
    }
};

/// What a hit hangs on: the least certain of all conditions.
Decider least_certain(const std::vector<Decider>& conditions) {
    return *std::ranges::min_element(conditions, {}, &Decider::times);
}

/// What a miss hangs on: the most certain of its reasons, t ≤ 0 among them. Three side products miss by two opposite
/// signs, of which the less certain counts.
Decider reason_of_miss(const std::vector<Decider>& numbers, const std::optional<Decider>& t) {
    std::vector<Decider> reasons;
    if (t && t->value < 0) reasons.push_back(*t);
    if (numbers.size() == 1 && numbers.front().value < 0) reasons.push_back(numbers.front());
    if (numbers.size() == 3) {
        const auto signed_times = [](const Decider& d) { return d.value < 0 ? -d.times() : d.times(); };
        const auto [negative, positive] = std::ranges::minmax_element(numbers, {}, signed_times);
        if (negative->value < 0 && positive->value > 0) reasons.push_back(least_certain({*negative, *positive}));
    }
    if (reasons.empty()) return numbers.empty() ? Decider{} : least_certain(numbers);
    return *std::ranges::max_element(reasons, {}, &Decider::times);
}

Decider verdict_hangs_on(std::vector<Decider> numbers, const std::optional<Decider>& t, bool is_met) {
    if (!is_met) return reason_of_miss(numbers, t);
    if (t) numbers.push_back(*t);
    return numbers.empty() ? Decider{} : least_certain(numbers);
}

/// The results of all formulas, gathered.
template <class Real, class Shape, class Rule>
class Gathered {
public:
    Gathered(const Shape& shape, std::span<const Rule> rules, bool is_met)
        : shape_(convert<Enclosure<Real>>(shape)), rules_(rules), is_met_(is_met) {}

    /// All rules for a ray whose t is in units of `unit` |D|.
    void add(const Ray<Enclosure<Real>>& ray, const Enclosure<Real>& unit, const char* with) {
        for (const Rule& rule : rules_) {
            Deciders<Real> heard;
            const Crossing<Enclosure<Real>> crossing = intersect(ray, shape_, Chosen{rule}, heard);
            const bool may_be_met = possibly(crossing.met);
            some_ |= may_be_met;
            all_ &= surely(crossing.met);
            if (may_be_met && !surely(crossing.met)) note_undecided(std::string(name_of(rule)), with);
            result_.has_bounds &= heard.are_known();
            const Bounded range = (crossing.t / unit).range();
            const bool has_t = range.value != 0 || range.error != 0;  // computed only where the line may meet it
            const auto t = has_t ? std::optional(Decider{"t", range.value, range.error}) : std::nullopt;
            if (may_be_met) take_t(range);
            if (is_first_) result_.decider = verdict_hangs_on(std::move(heard.numbers), t, is_met_);
            is_first_ = false;
        }
    }

    Possible take() && {
        result_.met = all_ ? Kleene(true) : some_ ? Kleene::undecided() : Kleene(false);
        return std::move(result_);
    }

private:
    /// Of a formula that leaves it open anyway it does not matter that it does so with a unit D, too.
    void note_undecided(const std::string& name, const char* with) {
        if (std::ranges::count(result_.undecided_by, name) == 0) result_.undecided_by.push_back(name + with);
    }

    void take_t(const Bounded& range) {
        constexpr double infinity = std::numeric_limits<double>::infinity();
        const double error = Bounded::up(range.error + Bounded::u * std::abs(range.value));
        const double least = is_known(range) ? range.value - error : -infinity;
        const double most = is_known(range) ? range.value + error : infinity;
        result_.least_t = has_t_ ? std::min(result_.least_t, least) : least;
        result_.most_t = has_t_ ? std::max(result_.most_t, most) : most;
        has_t_ = true;
    }

    decltype(convert<Enclosure<Real>>(std::declval<const Shape&>())) shape_;
    std::span<const Rule> rules_;
    bool is_met_;
    Possible result_;
    bool some_ = false, all_ = true, has_t_ = false, is_first_ = true;
};

}  // namespace

template <class Real>
Possible possible(const Ray<Enclosure<Real>>& ray, const engine::Engine& surfaces, std::size_t surface, bool is_met,
                  const Formulas& formulas) {
    const auto gathered = [&]<class Shape, class Rule>(const Shape& shape, const std::vector<Rule>& rules) {
        Gathered<Real, Shape, Rule> all(shape, rules, is_met);
        all.add(ray, 1, "");
        const Enclosure<Real> size = length(ray.D);
        if (possibly(size != 1)) all.add({ray.P, ray.D / size}, size, " with unit D");
        return std::move(all).take();
    };
    return surfaces.with_surface(surface, [&]<class Shape>(const Shape& shape) {
        if constexpr (std::is_same_v<Shape, Sphere<double>>) return gathered(shape, formulas.spheres);
        else return gathered(shape, formulas.triangles);
    });
}

template Possible possible(const Ray<Enclosure<float>>&, const engine::Engine&, std::size_t, bool, const Formulas&);
template Possible possible(const Ray<Enclosure<double>>&, const engine::Engine&, std::size_t, bool, const Formulas&);

}  // namespace glassbox
