#pragma once
#include <string>
#include <vector>

namespace glassbox::engine {

/// A kind of vectors that this processor has and the inner loops are compiled for: "AVX3", say.
struct VectorKind {
    std::string name;
    bool is_right;  ///< computes what the inner loops ask of it to the same bits as doubles and floats one at a time
};

/// Tries all kinds. No other thread may use the inner loops meanwhile.
std::vector<VectorKind> try_vectors();

}  // namespace glassbox::engine
