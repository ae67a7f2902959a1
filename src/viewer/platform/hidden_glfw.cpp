#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include "scene/error.hpp"
#include "viewer/platform/hidden.hpp"

namespace glassbox {

HiddenContext::HiddenContext() {
    glfwInit();  // may fail, or have been called before: the window reports it. Never terminated: others may use it
    glfwWindowHint(GLFW_VISIBLE, GLFW_FALSE);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
    glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
    glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);
    glfwWindowHint(GLFW_OPENGL_DEBUG_CONTEXT, GLFW_TRUE);
    context_ = glfwCreateWindow(1, 1, "glassbox", nullptr, nullptr);
    if (context_ == nullptr) {
        const char* why = "no reason was given";
        glfwGetError(&why);
        throw Error(std::string("glassbox view: error: there is no OpenGL 3.3, not even for a hidden window (") + why +
                    ")");
    }
    make_current();
}

HiddenContext::~HiddenContext() { glfwDestroyWindow(static_cast<GLFWwindow*>(context_)); }

void HiddenContext::make_current() const { glfwMakeContextCurrent(static_cast<GLFWwindow*>(context_)); }

HiddenContext::Function HiddenContext::function(const char* name) { return glfwGetProcAddress(name); }

}  // namespace glassbox
