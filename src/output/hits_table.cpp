#include "output/hits_table.hpp"

#include <fmt/format.h>

#include <iterator>
#include <string>

#include "numerics/printed_bound.hpp"

namespace glassbox {

namespace {

constexpr std::size_t piece = 1 << 20;

std::string shortest(long double t, Scalar scalar) {
    switch (scalar) {
        case Scalar::float_:
            return fmt::format("{}", static_cast<float>(t));
        case Scalar::long_double:
            return fmt::format("{}", t);
        default:
            return fmt::format("{}", static_cast<double>(t));
    }
}

std::string row(std::size_t ray, const Shot& shot, Scalar scalar) {
    const bool proven = is_proven(scalar);
    const char* const decided = !proven ? "" : shot.by_filter ? "filter" : "exact";
    switch (shot.answer) {
        case Shot::Answer::hit:
            return fmt::format("{},hit,{},{},{},{},{}\n", ray, shot.surface, shortest(shot.t, scalar),
                               proven ? fmt::format("{}", bound_to_print(shot.t_error)) : "", decided, shot.hits);
        case Shot::Answer::miss:
            return fmt::format("{},miss,,,,{},0\n", ray, decided);
        default:
            return fmt::format("{},invalid,,,,,0\n", ray);
    }
}

}  // namespace

void hits_table(std::span<const Shot> shots, Scalar scalar, const Sink& sink) {
    std::string rows = "ray,verdict,surface,t,t_error,decided,hits\n";
    const auto flush = [&] {
        sink(std::as_bytes(std::span(rows)));
        rows.clear();
    };
    for (std::size_t i = 0; i < shots.size(); ++i) {
        rows += row(i, shots[i], scalar);
        if (rows.size() >= piece) flush();
    }
    flush();
}

}  // namespace glassbox
