#pragma once
#include <unistd.h>

#include <filesystem>
#include <string>
#include <utility>

namespace glassbox::test {

/// What `learn` makes once in a learner's folder, in many seconds, and which is the same in all of them: doctest and
/// the preludes, compiled. It is there, as a copy, if an earlier test has made it; and is kept for later ones at the
/// end.
class Prepared {
public:
    explicit Prepared(std::filesystem::path hidden) : hidden_(std::move(hidden)) { copy(kept(), hidden_); }
    Prepared(const Prepared&) = delete;
    Prepared& operator=(const Prepared&) = delete;
    ~Prepared() { copy(hidden_, kept()); }

private:
    static std::filesystem::path kept() { return PREPARED; }

    /// Each folder whole or not at all: other tests may be doing the same.
    static void copy(const std::filesystem::path& from, const std::filesystem::path& to) {
        namespace fs = std::filesystem;
        std::error_code failed;
        for (const fs::directory_entry& folder : fs::directory_iterator(from, failed)) {
            const std::string name = folder.path().filename().string();
            const bool tools = name.starts_with("tools-"), drawing = name.starts_with("drawing-");
            if ((!tools && !drawing) || fs::exists(to / name, failed)) continue;
            const fs::path making = to / ("copying-" + std::to_string(::getpid()) + name);
            fs::create_directories(making, failed);
            for (const fs::directory_entry& file : fs::directory_iterator(folder, failed))
                if (tools || file.path().filename().string().starts_with("prelude"))
                    fs::copy_file(file, making / file.path().filename(), failed);
            if (!failed) fs::rename(making, to / name, failed);
            if (failed) fs::remove_all(making, failed);
        }
    }

    std::filesystem::path hidden_;
};

}  // namespace glassbox::test
