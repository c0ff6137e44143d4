#pragma once

#include "texplorer/image/image.h"
#include "texplorer/sheet/layout.h"
#include "texplorer/sheet/lettering.h"

#include <string>
#include <vector>

namespace texplorer::sheet {

/// A sheet that is filled as pictures arrive: dark text on a light background, a thin frame around each
/// picture. Different cells can be filled by different threads at once, each cell once.
class SheetPicture {
public:
    explicit SheetPicture(Layout layout);

    /// Rgba8, shown without its alpha, of the cell's extent.
    void put(std::size_t cell, const Image& picture);
    /// A text instead of the picture: why there is none.
    void refuse(std::size_t cell, std::string words);
    /// A text below the picture.
    void note(std::size_t cell, std::string words);

    /// Returns the sheet as Rgb8, with all texts.
    [[nodiscard]] Image take(const Lettering& lettering) &&;

private:
    void fill(const PixelRect& rect, Ink color);
    void frame(const PixelRect& rect);
    void writeRefusal(const Lettering& lettering, const PixelRect& cell, const std::string& words);

    Layout layout_;
    Image image_;
    std::vector<std::string> notes_;    ///< one per cell
    std::vector<std::string> refusals_; ///< one per cell; empty: none
};

} // namespace texplorer::sheet
