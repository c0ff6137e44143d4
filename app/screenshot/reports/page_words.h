#pragma once

#include "app/ui/language/catalogue.h"
#include "texplorer/text/html.h"
#include "texplorer/text/printable.h"

#include <memory>
#include <string>
#include <string_view>

namespace texplorer::screenshot {

[[nodiscard]] inline std::string htmlOf(std::string_view text) {
    return escapedHtml(printable(text, LineBreaks::Keep));
}

/// What a page says in its language, where there is a translation: the program's words, and a lesson's texts.
struct PageWords {
    const ui::Catalogue* words = nullptr;
    std::shared_ptr<const ui::Catalogue> texts{};

    [[nodiscard]] std::string word(const Sentence& english) const { return textIn(words, english); }
    [[nodiscard]] std::string text(const Sentence& english) const { return textIn(texts.get(), english); }

    // As they stand in HTML.
    [[nodiscard]] std::string wordHtml(const Sentence& english) const { return htmlOf(word(english)); }
    [[nodiscard]] std::string textHtml(const Sentence& english) const { return htmlOf(text(english)); }
};

} // namespace texplorer::screenshot
