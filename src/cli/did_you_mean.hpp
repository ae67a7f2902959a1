#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "scene/suggestion.hpp"

namespace glassbox {

/// "did you mean 'room'?", or nothing if no name is near: for words that need not be one of these names.
inline std::string did_you_mean(std::string_view word, const std::vector<std::string>& names) {
    const std::vector<std::string_view> known(names.begin(), names.end());
    std::string text = suggestion(word, known);
    return text.starts_with("did you mean") ? text : "";
}

}  // namespace glassbox
