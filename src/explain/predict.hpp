#pragma once
#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "explain/story.hpp"

namespace glassbox {

/// Goes through a pixel's story, and asks before each test what a reader expects. `say` is given the text, `read` asked
/// for the reader's next line: none at the end of the input. An empty line skips a question, "q" ends them all; the
/// score comes at the end.
void predict(const Story& story, const std::function<void(std::string_view)>& say,
             const std::function<std::optional<std::string>()>& read);

}  // namespace glassbox
