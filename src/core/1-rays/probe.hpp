#pragma once

namespace glassbox {

/// The probe that ignores everything. A formula reports what it computes to its probe, `probe(told::Name{}, values…)`;
/// a probe may count, keep or print it. This one compiles to no code at all.
struct Silent {
    template <class What, class... Values>
    constexpr void operator()(What, const Values&...) const {}
};

}  // namespace glassbox
