#pragma once
#include <string>

#include "explain/story.hpp"

namespace glassbox {

/// The story as JSON, each field as docs/explain.md says.
std::string to_json(const Story& story);

}  // namespace glassbox
