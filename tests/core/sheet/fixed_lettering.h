#pragma once

#include "texplorer/sheet/lettering.h"
#include "texplorer/text/utf8.h"

#include <algorithm>

namespace texplorer::sheet_test {

inline constexpr int letterWidth = 8;

/// Every letter is a box of 8 pixels, filled from the first of its line's rows to the last.
class FixedLettering : public sheet::Lettering {
public:
    [[nodiscard]] int width(sheet::TextRole, std::string_view text) const override {
        int letters = 0;
        for (; !text.empty(); ++letters)
            text.remove_prefix(std::max<std::size_t>(1, firstCharacter(text).bytes));
        return letters * letterWidth;
    }
    [[nodiscard]] int lineHeight(sheet::TextRole role) const override {
        constexpr std::array heights{24, 18, 16, 14};
        return heights.at(static_cast<std::size_t>(role));
    }
    void draw(Image& picture, int left, int top, sheet::TextRole role, std::string_view text,
              sheet::Ink ink) const override {
        for (int y = top; y < top + lineHeight(role); ++y) {
            for (int x = left; x < left + width(role, text); ++x) {
                for (std::size_t i = 0; i < ink.size(); ++i)
                    picture.at(x, picture.height - 1 - y)[i] = static_cast<std::byte>(ink[i]);
            }
        }
    }
};

} // namespace texplorer::sheet_test
