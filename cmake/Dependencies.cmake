# The compilers and libraries that Glassbox needs. All are Debian packages; ./glassbox installs them.
set(oldest_GNU 11)
set(oldest_Clang 14)
set(oldest ${oldest_${CMAKE_CXX_COMPILER_ID}})
if(oldest AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS oldest)
  message(FATAL_ERROR "${CMAKE_CXX_COMPILER} is version ${CMAKE_CXX_COMPILER_VERSION}, too old for Glassbox's C++20: "
    "it needs g++ 11 or clang++ 14, or newer.\nTo choose another: rm -r ${CMAKE_BINARY_DIR}; CXX=g++-12 ./glassbox")
endif()

# Everything that is missing, reported once at the end.
set(GLASSBOX_MISSING "")

# Finds a library that has a CMake package; `debian` is the Debian package that it is in.
macro(glassbox_package name debian)
  find_package(${name} QUIET)
  if(NOT ${name}_FOUND)
    list(APPEND GLASSBOX_MISSING ${debian})
  endif()
endmacro()

# Makes a target for a header-only library without a CMake package; looks for its headers only once.
function(glassbox_header_library name header debian)
  find_path(GLASSBOX_${name}_DIR ${header} PATH_SUFFIXES ${name})
  if(NOT GLASSBOX_${name}_DIR)
    set(GLASSBOX_MISSING ${GLASSBOX_MISSING} ${debian} PARENT_SCOPE)
    return()
  endif()
  add_library(glassbox_${name} INTERFACE)
  target_include_directories(glassbox_${name} SYSTEM INTERFACE ${GLASSBOX_${name}_DIR})
endfunction()

find_package(Threads REQUIRED)
glassbox_package(Boost libboost-dev)
glassbox_package(fmt libfmt-dev)
glassbox_package(TBB libtbb-dev)
glassbox_package(tomlplusplus libtomlplusplus-dev)
glassbox_package(tinyexr libtinyexr-dev)
glassbox_package(nlohmann_json nlohmann-json3-dev)
glassbox_package(hwy libhwy-dev)
find_package(embree 3 QUIET)  # to compare with; `bench --against embree` says what to install
glassbox_header_library(stb stb_image_write.h libstb-dev)
glassbox_header_library(cli11 CLI/CLI.hpp libcli11-dev)
if(GLASSBOX_TESTS)
  glassbox_header_library(doctest doctest.h doctest-dev)
endif()

if(GLASSBOX_MISSING)
  list(JOIN GLASSBOX_MISSING " " GLASSBOX_MISSING)
  message(FATAL_ERROR "Libraries are missing. By their Debian names: ${GLASSBOX_MISSING}\n"
    "Debian, Ubuntu: sudo apt-get install ${GLASSBOX_MISSING}\n"
    "Elsewhere: the same libraries from your package manager, or CMAKE_PREFIX_PATH set to where they are")
endif()
