#pragma once
#include <memory>
#include <utility>

namespace glassbox {

/// A large immutable value: its copies share it.
template <class T>
class Shared {
public:
    Shared(T value) : value_(std::make_shared<const T>(std::move(value))) {}

    operator const T&() const { return *value_; }
    const T* operator->() const { return value_.get(); }

private:
    std::shared_ptr<const T> value_;
};

}  // namespace glassbox
