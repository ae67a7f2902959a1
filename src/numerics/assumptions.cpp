#include "numerics/assumptions.hpp"

#include <bit>
#include <cfenv>
#include <cfloat>
#include <cmath>
#include <cstdint>
#include <limits>

#include <floating_point.hpp>

#include "numerics/dyadic.hpp"

namespace glassbox {

namespace {

/// Returns the same number, hidden from the compiler's optimizer.
template <class Real>
Real given(Real number) {
    volatile Real hidden = number;
    return hidden;
}

template <class Real>
inline constexpr Real ulp = std::numeric_limits<Real>::epsilon();

template <class Real>
bool has_ieee_format() {
    using Limits = std::numeric_limits<Real>;
    const bool wide = Limits::digits == 64 || Limits::digits == 113;  // x87's and most others'
    return Limits::is_iec559 && Limits::radix == 2 &&
           (sizeof(Real) == 4 ? Limits::digits == 24 : Limits::digits == 53 || (sizeof(Real) > 8 && wide));
}

/// Whether ties go to the even neighbour, on both sides of 0, and a number beside a tie to the nearer one.
template <class Real>
bool rounds_to_nearest() {
    const Real one = given(Real(1)), u = given(ulp<Real>), half = given(u / 2);
    const Real next = one + u;
    return next > one && one + half == one && next + half == one + 2 * u && -one - half == -one &&
           -next - half == -one - 2 * u && one + half * next == next && one - half / 2 == one;
}

/// a·b − a·b is 0 unless one of the products is fused with the difference, and so not rounded.
template <class Real>
bool rounds_each_operation() {
    const Real a = given(Real(0.1)), b = given(Real(1) / 3), c = given(Real(0.1)), d = given(Real(1) / 3);
    return a * b - c * d == 0;
}

/// Whether a term too small for the last place of a sum is lost, and no reordering brings it back; and whether x/n is
/// divided, not multiplied by the rounded 1/n: 41·(1/41) is not 1 in float, nor 49·(1/49) in double.
template <class Real>
bool keeps_the_order() {
    const Real big = given(Real(1)), small = given(ulp<Real> / 4);
    bool divides = true;
    for (const int n : {41, 49}) {
        const Real x = given(static_cast<Real>(n)), one = given(x), two = given(2 * x), three = given(3 * x);
        divides = divides && (one / x == 1) & (two / x == 2) & (three / x == 3);  // & instead of &&: divides all three
    }
    return (big + small) - big == 0 && (small - big) + big == 0 && divides;
}

template <class Real>
bool knows_nan_and_infinity() {
    using Limits = std::numeric_limits<Real>;
    const Real nan = given(Limits::quiet_NaN()), infinity = given(Limits::infinity()), most = given(Limits::max());
    return nan != nan && !(nan < 0) && !(nan > 0) && !(nan == 0) && infinity > most && 2 * most == infinity;
}

/// Whether the number is not 0, by its bits: a processor that treats subnormal numbers as 0 compares them as 0, too.
template <class Real>
bool is_there(Real number) {
    if constexpr (sizeof(Real) == 4) return std::bit_cast<std::uint32_t>(number) != 0;
    else if constexpr (sizeof(Real) == 8) return std::bit_cast<std::uint64_t>(number) != 0;
    else return number != 0;
}

/// Whether sums, differences, products and quotients can be subnormal.
template <class Real>
bool makes_subnormals() {
    using Limits = std::numeric_limits<Real>;
    const Real least = given(Limits::min()), half = given(Real(0.5)), two = given(Real(2));
    const Real next = least * (1 + ulp<Real>);
    return is_there(least * half) && is_there(least / two) && is_there(next - least) && is_there(-next + least);
}

template <class Real>
bool takes_subnormals() {
    using Limits = std::numeric_limits<Real>;
    const Real smallest = given(Limits::denorm_min()), scale = given(1 / ulp<Real>);
    return smallest > 0 && smallest * scale * 2 == Limits::min() * 2 && Limits::min() - smallest < Limits::min();
}

/// The number's exact value, as the sum of up to three doubles.
template <class Real>
Dyadic exact(Real number) {
    Dyadic sum;
    for (int n = 0; n < 3; ++n) {
        const auto part = static_cast<double>(number);
        sum = sum + Dyadic(part);
        number -= static_cast<Real>(part);
    }
    return sum;
}

/// Whether the computed root is the number nearest to the true one: x lies between the squares of the points halfway to
/// the root's neighbours.
template <class Real>
bool is_nearest_root(Real x) {
    using std::sqrt;
    const Real root = sqrt(given(x));
    const Dyadic up = exact(std::nextafter(root, std::numeric_limits<Real>::infinity())) + exact(root);
    const Dyadic down = exact(std::nextafter(root, Real(0))) + exact(root);
    const Dyadic four_x = Dyadic(4) * exact(x);
    return (four_x - down * down).sign() > 0 && (up * up - four_x).sign() > 0;
}

/// Tries hard cases, whose roots lie close to the midpoint of two numbers, and some others.
template <class Real>
bool rounds_roots() {
    const Real u = ulp<Real>;
    const auto least = static_cast<Real>(sizeof(Real) == 4 ? 0x1p-126 : 0x1p-1022);
    bool right = true;
    for (const Real x : {1 + u, 1 + 3 * u, 1 - u / 2, 1 - 3 * u / 2, 4 - 2 * u, 2 - u, 2 + 2 * u, Real(2), Real(3),
                         Real(0.1), 1 / Real(3), least, least * 3})
        right = right && is_nearest_root(x);
    return right;
}

/// Whether a double that a float cannot hold becomes the nearest float.
bool rounds_conversions() {
    const double tie = given(1 + 0x1p-24), above = given(1 + 0x1p-24 + 0x1p-52), odd = given(1 + 0x1.8p-23);
    return static_cast<float>(tie) == 1 && static_cast<float>(above) == 1 + 0x1p-23f &&
           static_cast<float>(odd) == 1 + 0x1p-22f && static_cast<float>(-above) == -1 - 0x1p-23f &&
           is_there(static_cast<float>(given(0x1p-149)));
}

/// "float, double": the scalars for which a check fails.
template <class Check>
std::string not_in(const Check& holds) {
    std::string names;
    const auto look = [&]<class Real>(const char* name, Real one) {
        if (!holds(one)) names.append(names.empty() ? "" : ", ").append(name);
    };
    look("float", 1.0f);
    look("double", 1.0);
    look("long double", 1.0L);
    return names;
}

}  // namespace

std::vector<Assumption> try_assumptions() {
    const std::string rebuild = "rebuild with the project's own CMakeLists.txt, without extra compiler flags";
    const std::string build_flags = rebuild + " (it sets -ffp-contract=off and refuses -ffast-math)";
    const std::string process =
        "look for what changes it in this process: a library that was built with -ffast-math, or LD_PRELOAD";
    const auto number = [](bool holds) { return holds ? "" : "double"; };
    return {
        {"numbers have IEEE 754's formats", not_in([]<class Real>(Real) { return has_ieee_format<Real>(); }),
         "build for another machine"},
        {"each operation is rounded to its own type", number(FLT_EVAL_METHOD == 0), "build for a machine with SSE2"},
        {"rounding is to nearest, ties to even", not_in([]<class Real>(Real) { return rounds_to_nearest<Real>(); }),
         process},
        {"a·b − c·d is rounded as written, not contracted",
         not_in([]<class Real>(Real) { return rounds_each_operation<Real>(); }), build_flags},
        {"sums and quotients are computed as written, not reordered",
         not_in([]<class Real>(Real) { return keeps_the_order<Real>(); }), build_flags},
        {"NaN and infinity are known", not_in([]<class Real>(Real) { return knows_nan_and_infinity<Real>(); }),
         build_flags},
        {"results below the normal numbers are kept, not flushed to 0",
         not_in([]<class Real>(Real) { return makes_subnormals<Real>(); }), process},
        {"numbers below the normal ones are taken as they are, not as 0",
         not_in([]<class Real>(Real) { return takes_subnormals<Real>(); }), process},
        {"square roots are the nearest numbers", not_in([]<class Real>(Real) { return rounds_roots<Real>(); }),
         "build with another C library or compiler"},
        {"a double becomes the nearest float", rounds_conversions() ? "" : "float", process},
    };
}

}  // namespace glassbox
