#pragma once
#include <deque>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace glassbox {

/// A header, as it was when what it computes was compiled.
struct SourceFile {
    std::string_view
        path;  ///< of ours, from the folder `src` on: "core/1-rays/vec3.hpp"; of a learner's: "my/2-spheres/chord.hpp"
    std::string_view text;
};

/// Headers that are not ours, and the texts that tapes recorded with them point to.
class OwnSources {
public:
    OwnSources() = default;
    OwnSources(const OwnSources&) = delete;  // others point into it
    OwnSources& operator=(const OwnSources&) = delete;

    void add(std::string path, std::string text) {
        texts_.push_back(std::move(path));
        const std::string_view kept_path = texts_.back();
        texts_.push_back(std::move(text));
        files_.push_back({kept_path, texts_.back()});
    }
    std::span<const SourceFile> files() const { return files_; }

    /// Keeps a text, and returns where it lies from then on.
    const char* keep(std::string text) {
        texts_.push_back(std::move(text));
        return texts_.back().c_str();
    }

private:
    std::deque<std::string> texts_;
    std::vector<SourceFile> files_;
};

}  // namespace glassbox
