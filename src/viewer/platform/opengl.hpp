#pragma once

// All systems that we build for export OpenGL 3.3's functions from their OpenGL library: no loader is needed.
#if defined(__APPLE__)
#include <OpenGL/gl3.h>
#else
#define GL_GLEXT_PROTOTYPES
#include <GL/glcorearb.h>
#endif
