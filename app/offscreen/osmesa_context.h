#pragma once

#include "app/view/frame.h"
#include "core/base/result.h"

#include <memory>

namespace texplorer::offscreen {

/// An OSMesa context (compatibility profile) that is current on the thread that created it, until it is
/// destroyed. It has its own framebuffer of `size` pixels, bottom row first. Needs no display.
class OsmesaContext {
public:
    [[nodiscard]] static Result<OsmesaContext> create(view::Size size);
    OsmesaContext(const OsmesaContext&) = delete;
    OsmesaContext& operator=(const OsmesaContext&) = delete;
    OsmesaContext(OsmesaContext&&) noexcept;
    OsmesaContext& operator=(OsmesaContext&&) noexcept;
    ~OsmesaContext();

private:
    struct State;
    explicit OsmesaContext(std::unique_ptr<State> state);
    std::unique_ptr<State> state_;
};

} // namespace texplorer::offscreen
