#pragma once
#include <filesystem>

namespace glassbox {

/// The folder of the program that runs; empty where the system does not tell.
std::filesystem::path program_folder();

/// The folder with what comes with Glassbox and is read as it runs: scenes/, lessons/, and the sources that learners'
/// programs are compiled with. Of an installed program that is ../share/glassbox, else the folder that it was built
/// from. Empty if neither is there.
std::filesystem::path shipped_folder();

/// The file as it is named; or, if there is none, the one that has this place in that folder: lessons/1-rays/rays.csv.
std::filesystem::path here_or_shipped(const std::filesystem::path& named);

}  // namespace glassbox
