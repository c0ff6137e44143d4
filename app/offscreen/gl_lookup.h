#pragma once

namespace texplorer::offscreen {

using AnyFunction = void (*)();

/// A function of OpenGL, as the library that makes the contexts finds it; nullptr: there is none.
[[nodiscard]] AnyFunction findGlFunction(const char* name);

} // namespace texplorer::offscreen
