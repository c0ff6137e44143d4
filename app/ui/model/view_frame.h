#pragma once

#include "app/view/frame.h"
#include "app/view/side.h"
#include "core/compare/difference.h"
#include "core/compare/heat_map.h"
#include "core/image/image.h"
#include "core/scene/renderer.h"

#include <memory>
#include <optional>

namespace texplorer::ui {

/// What a renderer has drawn for the view.
struct ViewFrame {
    RendererKind renderer = RendererKind::Fixed;
    view::Frame frame;                  ///< its picture may be smaller than its size: a coarse picture
    std::shared_ptr<const Image> image; ///< the pixels, where the views want them and the picture is whole
    /// Nothing better is on its way: the picture is of the scene as it is now, and not a coarse one. Where
    /// there is no picture, there will be none, and the frame's problems say why.
    bool whole = true;
    view::Side side = view::Side::Now;
};

/// How far the two pictures that are compared are apart.
struct ViewDifference {
    Difference numbers;
    HeatScale scale;
    view::PictureHandle heatMap = view::PictureHandle::None; ///< of the size of the pictures
};

} // namespace texplorer::ui
