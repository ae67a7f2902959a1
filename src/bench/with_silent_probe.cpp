#include "bench/bare_numbers.hpp"
#include "bench/sum_of_t.inl"

namespace glassbox {

double sum_of_t_with_silent_probe(const BareNumbers& numbers) {
    const Silent probe;
    return sum_of_t(numbers, probe);
}

}  // namespace glassbox
