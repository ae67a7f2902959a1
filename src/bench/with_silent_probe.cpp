#include "bench/bare_numbers.hpp"
#include "bench/sum_of_t.inl"

namespace glassbox {

double sum_of_t_with_silent_probe(const BareNumbers& numbers) {
    return sum_of_t(numbers.spheres, numbers.triangles, numbers.rays);
}

}  // namespace glassbox
