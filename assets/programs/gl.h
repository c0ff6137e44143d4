#define GL_GLEXT_PROTOTYPES /* functions of OpenGL after 1.1, as glActiveTexture */
#define GLFW_INCLUDE_GLEXT
#include <GLFW/glfw3.h>
