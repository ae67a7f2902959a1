#include <support/random_bits.hpp>

namespace glassbox::test {

RandomBits::RandomBits() : engine_(2014) {}
std::uint64_t RandomBits::next() { return engine_(); }

}  // namespace glassbox::test
