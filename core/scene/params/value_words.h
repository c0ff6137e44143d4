#pragma once

#include "texplorer/base/sentence.h"
#include "texplorer/scene/params/params.h"

namespace texplorer {

/// A choice in a sentence: OpenGL's name, or the label of what is not OpenGL's.
[[nodiscard]] Sentence wordsOf(const EnumRow& choice);

/// A value in a sentence: "GL_REPEAT", "on", "0.5".
[[nodiscard]] Sentence wordsOf(const ParamRow& row, const Value& value);

} // namespace texplorer
