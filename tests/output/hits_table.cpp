// The table of `glassbox shoot`: a printed bound is still a bound.
#include "output/hits_table.hpp"

#include <doctest.h>

#include <cmath>
#include <cstdlib>
#include <random>
#include <sstream>

#include "numerics/decimal.hpp"

using namespace glassbox;

namespace {

/// The field t_error of each row.
std::vector<std::string> t_errors(const std::vector<Shot>& shots) {
    std::string table;
    hits_table(shots, Scalar::certified, [&](std::span<const std::byte> bytes) {
        table.append(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    });
    std::vector<std::string> errors;
    std::istringstream rows(table);
    for (std::string row; std::getline(rows, row);) {
        std::istringstream fields(row);
        for (int i = 0; i < 5; ++i) std::getline(fields, row, ',');
        errors.push_back(row);
    }
    errors.erase(errors.begin());  // the header
    return errors;
}

}  // namespace

TEST_CASE("t_error is not below the bound, read as a decimal or as a double, and hardly above it") {
    std::mt19937_64 random(1207);
    std::vector<Shot> shots(3000);
    for (Shot& shot : shots) {
        shot.answer = Shot::Answer::hit;
        const double mantissa = static_cast<double>(random() >> 11);
        shot.t_error = std::ldexp(mantissa, -static_cast<int>(random() % 300));
    }
    shots[0].t_error = 0;
    shots[1].t_error = 0x1p-1074;
    shots[2].t_error = 0x1p-53;
    const std::vector<std::string> printed = t_errors(shots);
    REQUIRE(printed.size() == shots.size());
    CHECK(printed[0] == "0");  // exactly known
    for (std::size_t i = 0; i < shots.size(); ++i) {
        const double bound = shots[i].t_error, read = std::strtod(printed[i].c_str(), nullptr);
        CAPTURE(printed[i]);
        REQUIRE(Decimal(bound) <= Decimal(printed[i]));
        REQUIRE(bound <= read);
        REQUIRE(read <= std::nextafter(bound, HUGE_VAL));
    }
}
