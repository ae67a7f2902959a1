#pragma once
#include <functional>
#include <memory>

#include "viewer/model/state/state.hpp"
#include "viewer/model/work/results.hpp"

namespace glassbox {

/// Computes what a state shows, in the background, and only what has changed. Uses all cores but one: that one is the
/// interface's.
class Background {
public:
    /// `wake` is called from other threads whenever there is something new.
    explicit Background(const std::function<void()>& wake);
    ~Background();

    /// Starts what is missing for this state, stops what is not needed any more, and puts into `results` what is ready.
    void update(const ViewerState& state, Results& results);

private:
    struct Work;
    std::unique_ptr<Work> work_;
};

}  // namespace glassbox
