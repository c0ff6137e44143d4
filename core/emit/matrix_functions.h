#pragma once

#include <string_view>

namespace texplorer::emit {

// Functions of C that take the place of what OpenGL 3.3 has no more: its matrices, vertices between glBegin
// and glEnd. The texts of rows in c_functions.cpp.

extern const std::string_view matrixText; ///< the type, multiply()
extern const std::string_view degreeText;
extern const std::string_view identityText;
extern const std::string_view translationText;
extern const std::string_view rotationText;
extern const std::string_view scalingText;
extern const std::string_view aboutText;   ///< with what turns or scales moved to a pivot
extern const std::string_view frustumText; ///< perspective()
extern const std::string_view orthographicText;
extern const std::string_view floatProductText; ///< multiplyFloats()
extern const std::string_view setMatrixText;
extern const std::string_view setNormalMatrixText;
extern const std::string_view compileText; ///< newProgram()
extern const std::string_view bufferText;  ///< fillBuffer(), attribute()

} // namespace texplorer::emit
