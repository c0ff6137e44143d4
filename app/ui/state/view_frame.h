#pragma once

#include "app/view/frame.h"
#include "app/view/side.h"
#include "texplorer/compare/difference.h"
#include "texplorer/compare/heat_map.h"
#include "texplorer/image/image.h"
#include "texplorer/scene/renderer.h"

#include <memory>

namespace texplorer::ui {

/// The result of a renderer for the view.
struct ViewFrame {
    RendererKind renderer = RendererKind::Fixed;
    view::Frame frame;                  ///< its picture may be smaller than its size: a coarse picture
    std::shared_ptr<const Image> image; ///< the pixels, if a view needs them and the picture is complete
    /// The picture is final: of the current scene, and not a coarse one. Without a picture, there will be
    /// none, and the frame's problems say why.
    bool whole = true;
    view::Side side = view::Side::Now;
};

/// The difference of the two compared pictures.
struct ViewDifference {
    Difference numbers;
    HeatScale scale;
    view::PictureHandle heatMap = view::PictureHandle::None; ///< has the size of the pictures
};

} // namespace texplorer::ui
