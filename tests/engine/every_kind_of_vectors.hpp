#pragma once
#include <hwy/targets.h>

#include <cstdint>

namespace glassbox::test {

/// Calls `check(target)` with each kind of vectors that this processor has, while they are in use.
template <class Check>
void with_every_kind_of_vectors(const Check& check) {
    const auto use = [](std::int64_t target) {
        hwy::SetSupportedTargetsForTest(target);
        hwy::GetChosenTarget().Update(hwy::SupportedTargets());
    };
    for (const std::int64_t target : hwy::SupportedAndGeneratedTargets()) {
        use(target);
        check(target);
    }
    use(0);  // all, as it was
}

}  // namespace glassbox::test
