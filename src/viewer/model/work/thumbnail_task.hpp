#pragma once
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "render/job.hpp"
#include "viewer/model/files/thumbnail.hpp"
#include "viewer/model/work/picture_request.hpp"

namespace glassbox {

/// Small pictures of the scenes that are listed, one after the other; those of files that have not changed are kept.
struct DrawThumbnails {
    using Request = std::vector<std::pair<std::filesystem::path, FileVersion>>;
    using Result = std::shared_ptr<const Thumbnails>;

    static std::optional<Request> wanted(const ViewerState& state) {
        if (!state.scene_menu.shown) return {};
        Request files;
        for (const SceneRow& row : state.scene_menu.listed)
            if (!row.is_folder) files.emplace_back(row.path, row.version);
        return files;
    }
    static void perform(const Request& files, const Run& run, const auto& deliver) {
        Thumbnails& kept = run.tools.thumbnails;
        for (const auto& [file, version] : files) {
            if (const auto found = kept.find(file); found != kept.end() && found->second.version == version) continue;
            kept.insert_or_assign(file, thumbnail(file, version, {.threads = background_threads(), .stop = run.stop}));
            deliver(std::make_shared<const Thumbnails>(kept));
        }
    }
    static void show(Result thumbnails, Results& results) { results.thumbnails = std::move(thumbnails); }
};

}  // namespace glassbox
