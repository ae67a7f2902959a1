#pragma once
#include <filesystem>
#include <map>
#include <string>

#include "learn/course/workspace.hpp"

namespace glassbox::learn {

/// How far a function has come, as of the last test. Waiting: it calls another function that is not written yet.
enum class State { unknown, not_written, waiting, failing, passed };

/// What is remembered of a lesson.
struct LessonProgress {
    bool passed = false;                     ///< its tests have passed, at some time
    bool gave_up = false;                    ///< the solution was shown before that
    int runs = 0;                            ///< how often it was tested
    std::map<std::string, int> hints;        ///< function → how many hints were shown
    std::map<std::string, State> functions;  ///< as of the last test
    std::string tested;                      ///< what was tested: a fingerprint of the learner's headers
};

/// What is remembered of a learner's folder: its .glassbox/progress.json.
struct Progress {
    std::map<std::string, LessonProgress> lessons;  ///< by the lesson's name, "2-spheres"
};

/// Reads the progress from a file; empty if there is no such file. A file that cannot be read is renamed to
/// NAME.unreadable, and `complaint` says so.
Progress read_progress(const std::filesystem::path& file, std::string& complaint);

/// Returns the lesson where the learner is: the first that is begun and not passed, or else the first that is not
/// passed; the last one if all are passed.
const Exercise& present_exercise(const Workspace& workspace, const Progress& progress);

void write_progress(const std::filesystem::path& file, const Progress& progress);

}  // namespace glassbox::learn
