#pragma once

// The triangles, lines and points of a scene, set up for rasterising, in OpenGL's drawing order: by pass,
// then by model.

#include "texplorer/reference/raster/triangle.h"
#include "texplorer/reference/shading/pass_state.h"
#include "texplorer/scene/scene.h"

#include <functional>
#include <span>
#include <stop_token>

namespace texplorer::reference {

/// Calls `work` for each, clipped and set up. Their `pass` points into `passes`, which must outlive them.
/// Ends early after a stop request.
void eachTriangle(const Scene& scene, std::span<const PassState> passes, double time, Viewport viewport,
                  const std::stop_token& stop, const std::function<void(const Triangle&)>& work);

} // namespace texplorer::reference
