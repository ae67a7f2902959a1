#pragma once
#include <cstddef>
#include <utility>
#include <vector>

namespace glassbox {

/// A value and all its earlier versions: undo and redo.
template <class Value>
class History {
public:
    History() : versions_(1) {}
    explicit History(Value first) : versions_{std::move(first)} {}

    const Value& now() const { return versions_[at_]; }

    /// A new version, unless it is the present one. What had been undone is forgotten.
    void change(Value next) {
        if (next == now()) return;
        versions_.resize(at_ + 1);
        versions_.push_back(std::move(next));
        at_ = versions_.size() - 1;
    }

    /// Changes the present version and keeps no trace of what it was: for the steps of one drag of a slider.
    void amend(Value next) {
        versions_.resize(at_ + 1);
        versions_[at_] = std::move(next);
    }

    bool can_undo() const { return at_ > 0; }
    bool can_redo() const { return at_ + 1 < versions_.size(); }
    void undo() { at_ -= can_undo() ? 1 : 0; }
    void redo() { at_ += can_redo() ? 1 : 0; }

private:
    std::vector<Value> versions_;
    std::size_t at_ = 0;
};

}  // namespace glassbox
