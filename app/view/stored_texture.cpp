#include "app/view/stored_texture.h"

#include <fmt/core.h>

#include <cctype>

namespace texplorer::view {

std::string bitsText(const StoredLevel& level) {
    std::string text;
    for (std::size_t i = 0; i < level.bits.size(); ++i) {
        if (level.bits.at(i) > 0)
            text += fmt::format("{}{}{}", text.empty() ? "" : " ",
                                static_cast<char>(std::toupper(storedComponents.at(i).front())),
                                level.bits.at(i));
    }
    return text;
}

Sentence storedText(const StoredLevel& level) {
    const ProperName format{level.internalFormat};
    return level.bytes > 0 ? Sentence("{0}, {1} bytes", format, level.bytes)
                           : Sentence("{0}, {1}", format, ProperName{bitsText(level)});
}

} // namespace texplorer::view
