#pragma once

#include "texplorer/base/sentence.h"

namespace texplorer {

/// What is said first, and what there is to add.
inline constexpr Sentence::Key<Sentence, Sentence> furtherKey = "{0}; {1}";

} // namespace texplorer
