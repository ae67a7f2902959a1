#pragma once
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "learn/course/workspace.hpp"

namespace glassbox::learn {

/// What a learner has handed in: their workspace, wherever in the folder it lies.
struct HandedIn {
    std::string learner;  ///< the folder's name
    Workspace workspace;
    std::vector<std::string> notes = {};  ///< what is not where it belongs, or is missing: lines with places
};

/// Looks for lessons' folders in a learner's folder, and if there are none, in its subfolders: a `my` or all of
/// Glassbox may have been handed in. A lesson's folder may be called "1-Rays", "1_rays" or "rays", too. Files found
/// outside a lesson's folder are noted, and not looked at. Throws Error if there is no such folder.
HandedIn handed_in(const Workspace& teacher, const std::filesystem::path& folder);

/// The same for several, before any of them is graded: leaves out what is not a folder, and tells `say`. Learners whose
/// folders have the same name are called by their paths. Throws Error if there is no such path, or no folder is left.
std::vector<HandedIn> all_handed_in(const Workspace& teacher, const std::vector<std::filesystem::path>& paths,
                                    const std::function<void(const std::string&)>& say);

}  // namespace glassbox::learn
