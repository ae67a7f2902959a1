#include "bench/bare_numbers.hpp"
#include "bench/sum_of_t.inl"

namespace glassbox {

namespace {

/// Counts as `measure --what tests,hits` does.
struct Counts {
    double tests = 0, hits = 0;

    template <class What, class... Values>
    void operator()(What, const Values&...) {
        if constexpr (std::is_same_v<What, told::Tested>) ++tests;
        if constexpr (std::is_same_v<What, told::Met>) ++hits;
    }
};

}  // namespace

double sum_of_t_with_counting_probe(const BareNumbers& numbers) {
    Counts counts;
    const double sum = sum_of_t(numbers, counts);
    return counts.hits <= counts.tests ? sum : 0;  // uses both, so that the compiler counts both
}

}  // namespace glassbox
