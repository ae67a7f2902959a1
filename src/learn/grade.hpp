#pragma once
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <stop_token>
#include <string>

#include "learn/handed_in.hpp"
#include "learn/standing.hpp"
#include "learn/toolchain.hpp"
#include "learn/workspace.hpp"

namespace glassbox::learn {

/// Says how learners stand. What it makes lies in the hidden folder of the teacher's own workspace; in the folders that
/// it looks at nothing is changed.
class Grader {
public:
    /// `say` is told what is being done. Throws Error if there is no compiler.
    Grader(Workspace teacher, std::function<void(const std::string&)> say);

    /// How a learner stands: every lesson begun is tested, and its picture drawn. Throws Error if the machine cannot do
    /// it; Cancelled when asked to stop.
    LearnerStanding grade(const HandedIn& handed_in, const std::stop_token& stop = {});

private:
    LessonStanding grade(const Workspace& learner, const Exercise& exercise, const std::stop_token& stop);
    const std::optional<Image>& ours(const Exercise& exercise, const std::stop_token& stop);

    Workspace teacher_;
    std::function<void(const std::string&)> say_;
    Toolchain tools_;
    std::filesystem::path scratch_;
    std::map<int, std::optional<Image>> ours_;  ///< by the lesson's number
};

}  // namespace glassbox::learn
