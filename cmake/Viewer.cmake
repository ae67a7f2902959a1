# Whether the viewer is built, and the libraries that only it needs. Sets GLASSBOX_HAS_VIEWER, and with it the targets
# glassbox_imgui (Dear ImGui with its GLFW and OpenGL 3 backends) and glassbox_opengl.
set(GLASSBOX_VIEWER AUTO CACHE STRING "Build the viewer: AUTO (where its libraries are found), ON or OFF")
set_property(CACHE GLASSBOX_VIEWER PROPERTY STRINGS AUTO ON OFF)
set(GLASSBOX_HAS_VIEWER OFF)
if(NOT GLASSBOX_VIEWER STREQUAL "AUTO" AND NOT GLASSBOX_VIEWER)
  return()
endif()

set(missing "")
find_package(glfw3 3.3 QUIET)
if(NOT glfw3_FOUND)
  list(APPEND missing libglfw3-dev)
endif()
find_package(OpenGL QUIET OPTIONAL_COMPONENTS EGL)  # without EGL, drawing without a display needs a hidden window
if(NOT OPENGL_FOUND)
  list(APPEND missing "libgl-dev or libopengl-dev")
endif()
# Use the system's Dear ImGui if it has both backends. Otherwise, if the viewer is asked for, download a release: not
# with AUTO, because a failed download would stop the rest of the build.
find_package(PkgConfig QUIET)
if(PkgConfig_FOUND)
  pkg_check_modules(GLASSBOX_IMGUI QUIET IMPORTED_TARGET imgui>=1.86)
  find_path(GLASSBOX_IMGUI_BACKENDS backends/imgui_impl_glfw.h HINTS ${GLASSBOX_IMGUI_INCLUDE_DIRS} PATH_SUFFIXES imgui)
endif()
if(GLASSBOX_IMGUI_FOUND AND GLASSBOX_IMGUI_BACKENDS)
  set(imgui PkgConfig::GLASSBOX_IMGUI)
elseif(NOT GLASSBOX_VIEWER STREQUAL "AUTO")
  set(imgui glassbox_imgui_release)
else()
  list(APPEND missing pkg-config libimgui-dev)
endif()
glassbox_find_font(GLASSBOX_MONO_FONT DejaVuSansMono.ttf)
if(NOT GLASSBOX_MONO_FONT)
  list(APPEND missing "fonts-dejavu-core (DejaVuSansMono.ttf)")
endif()

if(missing)
  list(JOIN missing ", " missing)
  if(GLASSBOX_VIEWER STREQUAL "AUTO")
    message(STATUS "The viewer is left out: missing, by their Debian names, are ${missing}")
  else()
    message(FATAL_ERROR "The viewer needs libraries that are missing. By their Debian names: ${missing}\n"
      "To build without it: -DGLASSBOX_VIEWER=OFF")
  endif()
  return()
endif()
set(GLASSBOX_HAS_VIEWER ON)

add_library(glassbox_opengl INTERFACE)
target_link_libraries(glassbox_opengl INTERFACE OpenGL::GL)
if(imgui STREQUAL "glassbox_imgui_release")
  include(FetchContent)
  FetchContent_Declare(imgui
    URL https://github.com/ocornut/imgui/archive/refs/tags/v1.92.5.tar.gz
    URL_HASH SHA256=0eb50fe9aeba1a51f96b5843c7f630a32ed2e9362d693c61b87e4fa870cf826d)
  FetchContent_MakeAvailable(imgui)  # has no CMakeLists.txt: this only unpacks it
  set(sources imgui.cpp imgui_draw.cpp imgui_tables.cpp imgui_widgets.cpp backends/imgui_impl_glfw.cpp backends/imgui_impl_opengl3.cpp)
  list(TRANSFORM sources PREPEND ${imgui_SOURCE_DIR}/)
  add_library(glassbox_imgui_release STATIC ${sources})
  target_include_directories(glassbox_imgui_release SYSTEM PUBLIC ${imgui_SOURCE_DIR})
  target_link_libraries(glassbox_imgui_release PUBLIC glfw)
endif()
add_library(glassbox_imgui INTERFACE)
# A static imgui does not declare that its backends call GLFW, and finds OpenGL's functions by itself.
target_link_libraries(glassbox_imgui INTERFACE ${imgui} glfw glassbox_opengl ${CMAKE_DL_LIBS})
