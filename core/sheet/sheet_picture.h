#pragma once

#include "core/image/image.h"
#include "core/sheet/layout.h"
#include "core/sheet/lettering.h"

#include <string>
#include <vector>

namespace texplorer::sheet {

/// A sheet that is filled as its pictures come: dark words on a light ground, a thin frame around each
/// picture, whose pixels are its own. Different cells may be filled on different threads at once, each once.
class SheetPicture {
public:
    explicit SheetPicture(Layout layout);

    /// Rgba8 as it is seen, without its alpha, of the cell's extent.
    void put(std::size_t cell, const Image& picture);
    /// Words in the picture's place: why there is none.
    void refuse(std::size_t cell, std::string words);
    /// In the line below the picture.
    void note(std::size_t cell, std::string words);

    /// Rgb8, with all words.
    [[nodiscard]] Image take(const Lettering& lettering) &&;

private:
    void fill(const PixelRect& rect, Ink color);
    void frame(const PixelRect& rect);
    void writeRefusal(const Lettering& lettering, const PixelRect& cell, const std::string& words);

    Layout layout_;
    Image image_;
    std::vector<std::string> notes_;    ///< of each cell
    std::vector<std::string> refusals_; ///< of each cell; empty: there is none
};

} // namespace texplorer::sheet
