#pragma once

#include "app/render/capabilities.h"
#include "app/render/picture_cache.h"
#include "app/render/shader_renderer.h"
#include "app/ui/model/rendered_view.h"
#include "app/ui/model/session.h"

#include <array>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace texplorer::stage {

/// The pictures that the view shows, by whichever renderers it asks for. A renderer is made when it is first
/// needed. Belongs to the context that is current, on its thread, and must be destroyed before that.
class ViewPictures {
public:
    ViewPictures(const view::Capabilities& capabilities, render::ShaderOptions shaders);

    /// To be called once a frame, before the panels are drawn: the views are valid until the next call.
    void draw(ui::Session& session, view::Size size);

    /// In the order of ui::shownRenderers; never empty after `draw`.
    [[nodiscard]] const std::vector<ui::RenderedView>& views() const { return views_; }

    /// Of the two that the session compares; nullptr: it doesn't, or one of them isn't whole.
    [[nodiscard]] const ui::RenderedDifference* difference() const {
        return difference_ ? &*difference_ : nullptr;
    }

    /// Of each pass; empty where nobody looks at them.
    [[nodiscard]] const std::vector<std::shared_ptr<const view::PassShader>>& shaders() const {
        return shaders_;
    }

    /// What the renderers said, each sentence once.
    [[nodiscard]] const std::vector<std::string>& problems() const { return problems_; }

    /// Whether an upload has to go on with the next frame.
    [[nodiscard]] bool isUnfinished() const;

private:
    /// One of the renderers that draw with OpenGL, and its pixels as they were read last.
    struct Live {
        Result<render::SceneRenderer> renderer;
        std::uint64_t revision = 0; ///< of the pixels
        std::shared_ptr<const Image> pixels{};
    };

    Live& liveOf(RendererKind kind);
    [[nodiscard]] ui::RenderedView drawLive(RendererKind kind, ui::Session& session, view::Size size);
    [[nodiscard]] ui::RenderedView drawReference(ui::Session& session, view::Size size);
    void addProblems(const std::vector<std::string>& problems);
    void compareViews(const ui::Views& views);

    view::Capabilities capabilities_;
    render::ShaderOptions shaderOptions_;
    std::map<RendererKind, Live> live_;
    render::PictureCache pictures_;
    std::vector<ui::RenderedView> views_;
    std::optional<ui::RenderedDifference> difference_;
    std::array<std::shared_ptr<const Image>, 2> compared_; ///< what the difference was made of
    std::shared_ptr<const Image> heatMap_;
    std::vector<std::string> problems_;
    std::vector<std::shared_ptr<const view::PassShader>> shaders_;
};

} // namespace texplorer::stage
