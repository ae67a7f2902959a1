#pragma once
#include <cstdint>
#include <random>

namespace glassbox::test {

/// Random bits, the same ones on every machine: the standard fixes its engines, but not its distributions.
class RandomBits {
public:
    RandomBits();
    std::uint64_t next();

private:
    std::mt19937_64 engine_;
};

}  // namespace glassbox::test
