#pragma once
#include <array>
#include <string_view>

#include <shading.hpp>

namespace glassbox {

/// What a number usually is, from one end of a slider to the other, and how it is shown there.
struct Range {
    double least, most;
    const char* format;  ///< as printf takes it
    bool logarithmic = false;
};

/// A number of `Shading`, 0 or more: what it is called wherever it is read, written or offered, and which member it is.
template <class Real>
struct Coefficient {
    std::string_view name;    ///< in scene files and scripts, and with -- before it as an option
    std::string_view symbol;  ///< in formulas
    const char* label;        ///< of its slider
    const char* unit;         ///< what stands for its value in help
    const char* help;
    Range usual;
    Real Shading<Real>::*member;
    std::string_view color_name{};                 ///< of its term's own colour, where that is not the surface's
    Vec3<Real> Shading<Real>::*color_member = {};  ///< null where it has none
};

/// One row a coefficient, for every scalar.
template <class Real>
inline constexpr std::array coefficients{
    Coefficient<Real>{
        "ambient",
        "k_a",
        "k_a ambient",
        "K",
        "factor of the ambient term, usually 0 to 1",
        {0, 1, "%.3f"},
        &Shading<Real>::k_a,
        "ambient_color",
        &Shading<Real>::ambient_color,
    },
    Coefficient<Real>{
        "diffuse",
        "k_d",
        "k_d diffuse",
        "K",
        "factor of the diffuse term, usually 0 to 1",
        {0, 1, "%.3f"},
        &Shading<Real>::k_d,
    },
    Coefficient<Real>{
        "specular",
        "k_s",
        "k_s specular",
        "K",
        "factor of the specular term, usually 0 to 1",
        {0, 1, "%.3f"},
        &Shading<Real>::k_s,
        "specular_color",
        &Shading<Real>::specular_color,
    },
    Coefficient<Real>{
        "exponent",
        "e",
        "exponent",
        "E",
        "exponent of the specular term: the larger, the smaller the highlight",
        {1, 1000, "%.1f", true},
        &Shading<Real>::exponent,
    },
};

/// The same shading in another scalar: each coefficient as `number(value, symbol)` has it, then each colour as
/// `color(value, name)`.
template <class To, class From, class Number, class Color>
Shading<To> converted(const Shading<From>& from, const Number& number, const Color& color) {
    Shading<To> to{};
    to.model = from.model;
    for (std::size_t i = 0; i < coefficients<To>.size(); ++i)
        to.*coefficients<To>[i].member = number(from.*coefficients<From>[i].member, coefficients<To>[i].symbol);
    for (std::size_t i = 0; i < coefficients<To>.size(); ++i)
        if (const auto member = coefficients<To>[i].color_member)
            to.*member = color(from.*coefficients<From>[i].color_member, coefficients<To>[i].color_name);
    return to;
}

}  // namespace glassbox
