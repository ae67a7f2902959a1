#!/usr/bin/env bash
# ./glassbox builds wherever its folder is: folders.sh GLASSBOX
#
# Each of several folders gets a copy of the script, with a program of one line in the place of ours. Once built, it is
# built again when a header changes, and only then.
set -euo pipefail
script=$(realpath "$1")
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
export XDG_CACHE_HOME=$scratch/cache

# Pretend that no package is missing, on any system.
mkdir "$scratch/stubs"
cat >"$scratch/stubs/dpkg-query" <<'END'
#!/bin/sh
for package; do printf '%s installed;' "$package"; done
END
printf '#!/bin/sh\nexit 1\n' >"$scratch/stubs/apt-get"
chmod +x "$scratch"/stubs/*
PATH=$scratch/stubs:$PATH

failed=0
wrong() {
    printf '%s: error: in the folder %q: %s\n' "$script" "$name" "$1" >&2
    failed=1
}

# make_project FOLDER
make_project() {
    mkdir -p "$1/scenes"
    cp "$script" "$1/glassbox"
    cat >"$1/CMakeLists.txt" <<'END'
cmake_minimum_required(VERSION 3.22)
project(tiny CXX)
file(GLOB headers CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/*.hpp)
add_executable(glassbox main.cpp)
target_include_directories(glassbox PRIVATE ${PROJECT_SOURCE_DIR})
target_compile_definitions(glassbox PRIVATE SCENES="${PROJECT_SOURCE_DIR}/scenes")
set_target_properties(glassbox PROPERTIES RUNTIME_OUTPUT_DIRECTORY bin)
END
    cat >"$1/CMakePresets.json" <<'END'
{ "version": 3, "configurePresets": [{ "name": "release", "binaryDir": "${sourceDir}/build" }] }
END
    echo '#define ANSWER "first"' >"$1/answer.hpp"
    cat >"$1/main.cpp" <<'END'
#include <answer.hpp>
#include <cstdio>
#include <filesystem>
int main() { std::puts(std::filesystem::is_directory(SCENES) ? ANSWER : "no scenes"); }
END
}

# says ANSWER STDERR: what the script then prints on stdout and on stderr.
says() {
    local out
    out=$("$folder/glassbox" doctor 2>"$scratch/err") || { cat "$scratch/err" >&2; wrong "it failed"; return; }
    [[ $out == "$1" ]] || wrong "it printed '$out', not '$1'"
    [[ $(cat "$scratch/err") == "$2" ]] || wrong "it said '$(cat "$scratch/err")', not '$2'"
}

for name in plain 'two words, zwölf Äpfel, 管' $'all of \'"&;^|<>`*?:$#(){}[]!\t\x01\n'; do
    folder=$scratch/$name
    make_project "$folder"
    says first 'glassbox: building'
    says first ''
    sleep 1.1 # as coarse as some file systems' time
    echo '#define ANSWER "second"' >"$folder/answer.hpp"
    says second 'glassbox: building'
    says second ''
done

# CMake itself takes a backslash for a path separator.
name='back\slash' folder=$scratch/$name
make_project "$folder"
if "$folder/glassbox" doctor 2>"$scratch/err"; then wrong "it did not refuse"; fi
grep -q '^glassbox: CMake cannot build in a folder with a backslash in its name: rename or move ' "$scratch/err" ||
    wrong "it said $(cat "$scratch/err")"

exit $failed
