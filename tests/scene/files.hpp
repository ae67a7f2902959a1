#pragma once
#include <doctest.h>

#include <filesystem>
#include <fstream>
#include <random>
#include <string>
#include <string_view>

#include "scene/error.hpp"

namespace glassbox::test {

/// A new folder for files, removed when the test is over.
class Folder {
public:
    Folder() {
        std::random_device random;
        do path_ = std::filesystem::temp_directory_path() / ("glassbox-" + std::to_string(random()));
        while (!std::filesystem::create_directory(path_));
    }
    ~Folder() {
        std::error_code ignored;
        std::filesystem::remove_all(path_, ignored);
    }
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;

    std::filesystem::path path() const { return path_; }

    std::filesystem::path write(const std::string& name, std::string_view text) const {
        std::ofstream(path_ / name, std::ios::binary) << text;
        return path_ / name;
    }

private:
    std::filesystem::path path_;
};

/// Returns what the work complains of, without the folder's name: "a.toml:3:9: error: …"; "no error" if it does not.
template <class Work>
std::string complaint(const Folder& folder, const Work& work) {
    try {
        work();
    } catch (const Error& error) {
        std::string message = error.what();
        const std::string prefix = folder.path().string() + "/";
        for (auto at = message.find(prefix); at != std::string::npos; at = message.find(prefix))
            message.erase(at, prefix.size());
        return message;
    }
    return "no error";
}

}  // namespace glassbox::test
