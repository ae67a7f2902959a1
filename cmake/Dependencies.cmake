# The libraries that Glassbox stands on; all are Debian packages (the names are in the script ./glassbox).
find_package(Threads REQUIRED)
find_package(fmt REQUIRED)
find_package(TBB REQUIRED)
find_package(tomlplusplus REQUIRED)
find_package(tinyexr REQUIRED)

# Header-only libraries without a CMake package: a target for each, its headers found once.
function(glassbox_header_library name header)
  find_path(GLASSBOX_${name}_DIR ${header} PATH_SUFFIXES ${ARGN} REQUIRED)
  add_library(glassbox_${name} INTERFACE)
  target_include_directories(glassbox_${name} SYSTEM INTERFACE ${GLASSBOX_${name}_DIR})
endfunction()
glassbox_header_library(stb stb_image_write.h stb)
glassbox_header_library(cli11 CLI/CLI.hpp)
if(GLASSBOX_TESTS)
  glassbox_header_library(doctest doctest.h doctest)
endif()
