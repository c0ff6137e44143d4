#pragma once

#include "app/stage/picture_cache.h"

namespace texplorer::opengl {

/// One of Dear ImGui's backends for OpenGL.
struct PanelBackend {
    void (*start)();
    void (*end)();
    void (*dropFonts)();
    void (*makeFonts)();
    void (*beginFrame)();
    void (*draw)(ImDrawData* panels);
};

/// The part of stage::Graphics that works with every OpenGL context, with any renderers: pictures as
/// textures, and the panels with a matching backend. Belongs to the current context and its thread, and must
/// be destroyed before the context.
class ContextGraphics : public stage::Graphics {
public:
    [[nodiscard]] view::PictureHandle show(const std::shared_ptr<const Image>& image, Use use) final {
        return pictures_.show(image, use);
    }
    void endFrame() final { pictures_.endFrame(); }
    void startPanels() final { backend_.start(); }
    void endPanels() final { backend_.end(); }
    void fontsChanged() final;
    void beginFrame() final { backend_.beginFrame(); }
    void drawPanels(ImDrawData& panels, view::Size pixels, const ImVec4& ground) final;
    [[nodiscard]] Image readPanels(view::Size pixels) final;
    [[nodiscard]] ImDrawCallback blendingSwitch() const final;

protected:
    explicit ContextGraphics(const PanelBackend& backend);

private:
    PanelBackend backend_;
    stage::PictureCache pictures_;
};

} // namespace texplorer::opengl
