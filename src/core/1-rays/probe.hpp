#pragma once

namespace glassbox {

/// The probe that listens to nothing. A formula tells its probe what it computes, `probe(told::Name{}, values…)`; what
/// a probe makes of that is its own affair (count it, keep it, print it). This one compiles to no code at all.
struct Silent {
    template <class What, class... Values>
    constexpr void operator()(What, const Values&...) const {}
};

}  // namespace glassbox
