#pragma once

// Sentences as arguments of fmt::format: their English texts.

#include "texplorer/base/sentence.h"

#include <fmt/core.h>

template<>
struct fmt::formatter<texplorer::Sentence> {
    static constexpr auto parse(format_parse_context& context) { return context.begin(); }
    static auto format(const texplorer::Sentence& sentence, format_context& context) {
        return fmt::format_to(context.out(), "{}", sentence.english()); // qualified: std has one, too
    }
};
