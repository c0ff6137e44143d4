#pragma once

// The seam between texshot and its GL half. Loading OSMesa costs a process about 17 ms of relocation, so
// everything that needs GL lives in a module that is loaded only when something is drawn. There is one for
// OSMesa and one for EGL, of the same sources: both libraries define gl* functions, and each module sees its
// own.

#include "app/ui/state/details_tabs.h"
#include "app/ui/state/figures.h"
#include "app/ui/state/sections.h"
#include "app/ui/state/settings.h"
#include "app/view/context_choice.h"
#include "app/view/offered_renderers.h"
#include "app/view/pretence.h"
#include "app/view/size.h"
#include "app/view/stored_texture.h"
#include "app/view/texture_cost.h"
#include "texplorer/base/result.h"
#include "texplorer/conform/pair.h"
#include "texplorer/conform/renderer.h"
#include "texplorer/diagnosis/diagnosis.h"
#include "texplorer/image/image.h"
#include "texplorer/reference/draw_request.h"
#include "texplorer/reference/explain/explanation.h"
#include "texplorer/reference/false_colors.h"
#include "texplorer/scene/renderer.h"
#include "texplorer/scene/scene.h"
#include "texplorer/texture/image_source.h"
#include "texplorer/texture/texture_levels.h"

#include <filesystem>
#include <memory>
#include <optional>

namespace texplorer::screenshot {

/// A frame, or the whole window, that texshot draws.
struct ShotRequest {
    Scene scene;
    ImageSource images;
    std::filesystem::path file;                    ///< of the scene; empty: none
    double time = 0;                               ///< seconds
    view::Size size;                               ///< of the picture, in pixels
    bool window = false;                           ///< the whole window with its panels, not just the scene
    std::optional<ui::Tab> tab{};                  ///< of the window, in front; none: as the layout has it
    std::optional<reference::PixelPlace> probed{}; ///< of the picture in the window, from its top left
    RendererKind renderer = RendererKind::Fixed;
    std::vector<RendererKind>
        compared{};                ///< in the window, instead of one renderer: two or three; empty: none
    std::filesystem::path shaders; ///< the folder of the shader renderer's files; empty: the built-in ones
    reference::AnisotropyMethod anisotropy = reference::AnisotropyMethod::Probes; ///< of the reference
    reference::RhoMethod rho = reference::RhoMethod::Ideal;                       ///< likewise
    std::optional<ui::Section> section{};               ///< of the window's parameters, to scroll to
    LevelWork levels{};                                 ///< how textures are compressed at run time
    view::Pretence pretence{};                          ///< what the driver is treated as lacking
    reference::Shown shown = reference::Shown::Picture; ///< of the window and of the reference
    reference::LevelQuestion shownUnit{}; ///< whose false colours; of the window: the selected one
    std::optional<ui::Figure> figure{};   ///< of the window, with its tab in front; none: as it has it
    ui::LayoutRow layout = ui::layoutRows.front(); ///< which panels of the window are open
    ui::Theme theme{};                             ///< of the window
    ui::Language language = ui::Language::English; ///< of the window
    std::string lesson{};                          ///< which is open in the window; empty: none
    std::size_t lessonStep = 0;                    ///< from 0
    bool rendererIsGiven = false;  ///< else the window of a lesson has the renderer that its step asks for
    bool shownIsGiven = false;     ///< likewise of `shown` and `shownUnit`
    int tour = 0;                  ///< the step of the tour over the window, from 1; 0: none
    float scale = 1;               ///< of the window's text and lengths
    bool largeControls = false;    ///< of the window
    view::ContextChoice context{}; ///< where OpenGL draws

    /// With the limits that are pretended, for all renderers.
    [[nodiscard]] ImageSource limitedImages() const {
        ImageSource limited = images;
        limited.setLimits(pretence.facts().limits());
        return limited;
    }
    /// Of the reference.
    [[nodiscard]] reference::DrawRequest drawRequest() const {
        return {scene, limitedImages(), time, size.width, size.height, anisotropy, rho};
    }
};

struct Shot {
    Frame frame;              ///< opaque where the window is drawn
    conform::Driver driver;   ///< that drew it; of the reference it has no name
    std::string context = {}; ///< see Studio; empty: none was needed
};

/// A texture as glGetTexImage returns it, and what OpenGL says of it.
struct ReadTexture {
    std::vector<TextureLevel> levels;
    view::StoredTexture stored;
};

/// A context that stays, and its renderers, for many pictures one after the other: programs, textures and
/// buffers that the next scene has, too, are not made anew. What it keeps is bounded, however many scenes it
/// draws. Used on the thread that opened it.
class Studio {
public:
    Studio() = default;
    Studio(const Studio&) = delete;
    Studio& operator=(const Studio&) = delete;
    virtual ~Studio() = default;

    [[nodiscard]] virtual conform::Driver driver() const = 0;
    /// How OpenGL is come by, as --context takes it: "osmesa", "egl:surfaceless".
    [[nodiscard]] virtual std::string context() const = 0;
    [[nodiscard]] virtual view::OfferedRenderers renderers() const = 0;
    /// Fixed function or the shaders, if it is offered; a request's anisotropy is the reference's. No file is
    /// read but those of shaders: the request's images hold what its textures name. `work`: how textures are
    /// compressed at run time, its progress and its stop. After an error the next request may be drawn.
    [[nodiscard]] virtual Result<Frame> draw(RendererKind renderer, const reference::DrawRequest& request,
                                             const LevelWork& work = {}) = 0;
    /// What the driver has of a texture of the scene that fixed function drew last. Fails if no unit showed
    /// it with this target.
    [[nodiscard]] virtual Result<ReadTexture> read(std::size_t texture, Target target) = 0;
    /// Measures this many pairs of each row.
    [[nodiscard]] virtual Result<view::TextureCosts> measure(view::CostSubject subject, std::size_t pairs,
                                                             const LevelWork& work) = 0;
};

/// The module's entry points, found by these names.
using DrawEntry = void (*)(const ShotRequest& request, Result<Shot>& shot);
inline constexpr const char* drawEntryName = "texshotDraw";
using StudioEntry = void (*)(const std::filesystem::path& shaders, const view::Pretence& pretence,
                             const view::ContextChoice& context, Result<std::unique_ptr<Studio>>& studio);
inline constexpr const char* studioEntryName = "texshotStudio";

/// Loads the module of the request's context beside this program and draws the window. The error says where
/// the module was looked for. Pictures of scenes: ShotDrawer.
[[nodiscard]] Result<Shot> draw(const ShotRequest& request);

/// Loads the module and opens a studio. `shaders`, `pretence` and `context` as in ShotRequest.
[[nodiscard]] Result<std::unique_ptr<Studio>> openStudio(const std::filesystem::path& shaders,
                                                         const view::Pretence& pretence,
                                                         const view::ContextChoice& context = {});

} // namespace texplorer::screenshot
