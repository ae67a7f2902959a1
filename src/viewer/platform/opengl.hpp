#pragma once

// OpenGL 3.3's functions. All systems that we build for export them from their OpenGL library: no loader is needed.
#if defined(__APPLE__)
#include <OpenGL/gl3.h>
#else
#define GL_GLEXT_PROTOTYPES
#include <GL/glcorearb.h>
#endif
