#pragma once
#include <string>

#include "explain/story.hpp"

namespace glassbox {

/// The story as JSON, with the fields of docs/explain.md.
std::string to_json(const Story& story);

}  // namespace glassbox
