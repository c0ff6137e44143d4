#pragma once

// Sentences as arguments of fmt::format: their English texts.

#include "texplorer/base/sentence.h"

#include <fmt/core.h>

template<>
struct fmt::formatter<texplorer::Sentence> : fmt::formatter<fmt::string_view> {
    auto format(const texplorer::Sentence& sentence, format_context& context) const {
        return formatter<fmt::string_view>::format(sentence.english(), context);
    }
};
