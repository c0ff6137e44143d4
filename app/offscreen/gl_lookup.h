#pragma once

namespace texplorer::offscreen {

using AnyFunction = void (*)();

/// Looks up an OpenGL function in the library that creates the contexts; nullptr if it is not found.
[[nodiscard]] AnyFunction findGlFunction(const char* name);

} // namespace texplorer::offscreen
