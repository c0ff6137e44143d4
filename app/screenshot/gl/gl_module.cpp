// The GL half of texshot: a context, the renderer and, for --ui, the panels.

#include "app/screenshot/gl/gl_module.h"

#include "app/offscreen/context.h"
#include "app/opengl/opengl_graphics.h"
#include "app/render/capabilities.h"
#include "app/render/cost_meter.h"
#include "app/render/driver_cache.h"
#include "app/render/shader_folder.h"
#include "app/render/shader_renderer.h"
#include "app/stage/loop.h"
#include "app/ui/files/lessons.h"
#include "app/ui/files/replaced_document.h"
#include "app/ui/model/session.h"
#include "app/ui/view/panes.h"
#include "app/ui/window/layout.h"
#include "app/view/driver_facts.h"
#include "texplorer/scene/params/keys.h"
#include "texplorer/scene/storage/obj_scene.h"
#include "texplorer/texture/levels_source.h"

#include <GL/glew.h>

#include <map>
#include <mutex>

namespace texplorer::screenshot {
namespace {

/// In the window files may be fixed while it is open, and other shaders draw until then. Here a picture is
/// drawn with these shaders or not at all.
Result<void> checkShaders(const std::filesystem::path& folder) {
    if (folder.empty())
        return {};
    const Result<glsl::ShaderPieces> pieces = render::readShaderFolder(folder);
    return pieces ? Result<void>() : fail(pieces.error());
}

Result<void> checkCompiled(const view::Frame& frame) {
    for (std::size_t p = 0; p < frame.shaders.size(); ++p) {
        if (frame.shaders[p] && !frame.shaders[p]->log.empty())
            return fail(ErrorCode::Malformed, frame.shaders[p]->log.front().sentence,
                        elementOf<&Scene::passes>(p));
    }
    return {};
}

conform::Driver driverOf(const view::Capabilities& capabilities) {
    std::string version = capabilities.version;
    if (!capabilities.pretending.empty())
        version += ", pretending " + capabilities.pretending;
    return {capabilities.renderer, std::move(version), {}, view::driverFacts(capabilities)};
}

constexpr int settlingFrames = 4; // until Dear ImGui has given every window its size, and scrolled there
constexpr int maxFrames = 40;     // of a window that is never finished

Result<Shot> drawWindow(const ShotRequest& request) {
    if (const Result<void> readable = checkShaders(request.shaders); !readable)
        return fail(readable.error());
    const Result<offscreen::Context> context = offscreen::Context::create(request.size, request.context);
    if (!context)
        return fail(context.error());
    const auto graphics = opengl::OpenGlGraphics::create({request.shaders, {}}, request.pretence);
    if (!graphics)
        return fail(graphics.error());

    std::vector<RendererKind> asked = request.compared;
    if (asked.empty())
        asked.push_back(request.renderer);
    for (const RendererKind each : asked) {
        if (!(*graphics)->renderers().has(each))
            return fail(ErrorCode::Unsupported, (*graphics)->renderers().whyNot(each));
    }

    ui::ServicesAtOnce services(request.levels);
    const bool isSource = isObjName(request.file); // the scene would become another file
    ui::Session session(services.lend(),
                        {request.scene, request.images, isSource ? std::filesystem::path() : request.file});
    ui::Workspace& workspace = session.settings.workspace;
    workspace = workspaceOf(request.layout);
    session.settings.theme = request.theme;
    session.settings.largeControls = request.largeControls;
    session.settings.language = request.language;
    session.window.systemLanguage = ui::languageOfSystem();
    session.window.textureUnits = (*graphics)->capabilities().textureUnits;
    const bool hasLesson = !request.lesson.empty();
    if (hasLesson) {
        if (const Result<void> opened = ui::openLessonNamed(session, request.lesson, request.lessonStep);
            !opened)
            return fail(opened.error());
        ui::Document changed(request.scene, request.images); // by the call: the step begins with its own
        changed.isLessons = true;
        changed.needsFit = false;
        ui::exchangeDocument(session, std::move(changed));
    }
    // What the call says goes before what the lesson's step wants to be looked at.
    if (!request.compared.empty())
        showComparison(session.view, request.compared);
    else if (!hasLesson || request.rendererIsGiven)
        showOne(session.view, request.renderer);
    session.view.anisotropy = request.anisotropy;
    session.view.rho = request.rho;
    if (!hasLesson || request.shownIsGiven) {
        session.view.shown = request.shown;
        session.look.selection.pass = request.shownUnit.pass;
        session.look.selection.unit = request.shownUnit.unit;
    }
    if (request.tab) {
        showTab(workspace, *request.tab);
        session.window.wantedTab = request.tab;
    }
    if (request.figure) {
        session.window.figure = *request.figure;
        session.window.wantedTab = ui::Tab::Figures;
    }
    if (request.tour > 0)
        session.window.tour = request.tour - 1;
    if (request.probed) {
        session.look.wantedProbe.reset();
        const ui::Rect picture = ui::layoutFor(request.size.width, request.size.height, request.scale,
                                               workspace, ui::gridOf(session.view), request.largeControls)
                                     .picture;
        const auto [x, y] = *request.probed;
        if (x >= picture.width || y >= picture.height)
            return fail(ErrorCode::OutOfRange,
                        Sentence("the picture in this window has {0} pixels, and none at {1},{2}",
                                 view::asText({picture.width, picture.height}), x, y),
                        atOption("--probe"));
        session.look.explaining.pixel = {x, picture.height - 1 - y};
    }
    session.look.playback.time = request.time;
    session.window.showsFrameTime = false;
    stage::Loop loop(**graphics, session, {request.size, request.size, request.scale});
    for (int frame = 0, last = settlingFrames; frame < std::min(last, maxFrames); ++frame) {
        session.out.wantedSection = request.section; // where it is, is known once the panel has its size
        if (loop.step(0, {}).unfinished)             // the scene's time stands still
            last = frame + 1 + settlingFrames;
    }

    Image image = Image::uninitialised(PixelFormat::Rgba8, request.size.width, request.size.height);
    glReadPixels(0, 0, image.width, image.height, GL_RGBA, GL_UNSIGNED_BYTE, image.pixels.data());
    return Shot{
        {std::move(image), loop.problems()}, driverOf((*graphics)->capabilities()), context->kind().text()};
}

/// Levels for one who waits for the picture and looks at nothing else: no numbers, no small pictures of them.
class LevelsAtOnce final : public LevelsSource {
public:
    explicit LevelsAtOnce(const LevelWork& work)
        : work_(work) {}
    std::shared_ptr<const PreparedLevels> prepare(const LevelsRequest& request) override {
        return std::make_shared<const PreparedLevels>(
            prepareLevels(request.settings, request.pictures, request.target, work_));
    }
    bool isLive() const override { return false; }
    void uploaded(const LevelsRequest& /*request*/, std::shared_ptr<const PreparedLevels> /*levels*/,
                  std::vector<TextureLevel> /*made*/) override {}

private:
    const LevelWork& work_;
};

class ContextStudio : public Studio {
public:
    ContextStudio(offscreen::Context context, view::Capabilities capabilities, std::filesystem::path shaders)
        : context_(std::move(context))
        , capabilities_(std::move(capabilities))
        , shaders_(std::move(shaders)) {}

    conform::Driver driver() const override { return driverOf(capabilities_); }

    view::OfferedRenderers renderers() const override { return render::offeredRenderers(capabilities_); }

    std::string context() const override { return context_.kind().text(); }

    Result<Frame> draw(RendererKind kind, const reference::DrawRequest& request,
                       const LevelWork& work) override {
        auto found = renderers_.find(kind);
        if (found == renderers_.end()) {
            if (const Result<void> readable =
                    kind == RendererKind::Shader ? checkShaders(shaders_) : Result<void>();
                !readable)
                return fail(readable.error());
            Result<render::SceneRenderer> made = render::createRenderer(kind, capabilities_, {shaders_, {}});
            if (!made)
                return fail(made.error());
            found = renderers_.emplace(kind, std::move(*made)).first;
        }
        LevelsAtOnce levels(work);
        Result<view::Frame> frame = found->second.draw(request.scene, request.images, request.time,
                                                       {request.width, request.height}, &levels);
        if (!frame)
            return fail(frame.error());
        if (!shaders_.empty()) {
            if (const Result<void> compiled = checkCompiled(*frame); !compiled)
                return fail(compiled.error());
        }
        Result<Image> image = found->second.read();
        if (!image)
            return fail(image.error());
        if (kind == RendererKind::Fixed)
            stored_ = std::move(frame->stored);
        return Frame{std::move(*image), std::move(frame->problems)};
    }

    Result<ReadTexture> read(std::size_t texture, Target target) override {
        const auto renderer = renderers_.find(RendererKind::Fixed);
        const auto stored = stored_.find({texture, target});
        if (renderer == renderers_.end() || stored == stored_.end())
            return fail(ErrorCode::NotFound, Sentence("it has not been drawn as {0}", rowOf(target).name),
                        elementOf<&Scene::textures>(texture));
        return renderer->second.readTexture(texture, target).map([&](std::vector<TextureLevel>&& levels) {
            return ReadTexture{std::move(levels), *stored->second};
        });
    }

    Result<view::TextureCosts> measure(view::CostSubject subject, std::size_t pairs,
                                       const LevelWork& work) override {
        constexpr std::chrono::milliseconds step(100); // between two looks at the stop
        render::CostMeter meter(capabilities_, std::move(subject), pairs);
        view::TextureCosts costs;
        while (meter.measure(costs, step)) {
            if (work.stop.stop_requested())
                return fail(ErrorCode::Cancelled, N_("cancelled"));
            if (work.progress)
                work.progress(static_cast<float>(progressOf(costs, pairs)));
        }
        return costs;
    }

private:
    offscreen::Context context_; // goes last
    view::Capabilities capabilities_;
    std::filesystem::path shaders_;
    std::map<RendererKind, render::SceneRenderer> renderers_;
    std::map<std::pair<std::size_t, Target>, std::shared_ptr<const view::StoredTexture>> stored_;
};

Result<std::unique_ptr<Studio>> openContextStudio(const std::filesystem::path& shaders,
                                                  const view::Pretence& pretence,
                                                  const view::ContextChoice& choice) {
    Result<offscreen::Context> context = offscreen::Context::create({1, 1}, choice);
    if (!context)
        return fail(context.error());
    Result<view::Capabilities> capabilities = render::loadCapabilities();
    if (!capabilities)
        return fail(capabilities.error());
    return std::make_unique<ContextStudio>(std::move(*context), pretence.of(std::move(*capabilities)),
                                           shaders);
}

} // namespace
} // namespace texplorer::screenshot

extern "C" [[gnu::visibility("default")]] void
texshotDraw(const texplorer::screenshot::ShotRequest& request,
            texplorer::Result<texplorer::screenshot::Shot>& shot) {
    using namespace texplorer::screenshot;
    texplorer::render::setUpDriverCache();
    shot = drawWindow(request);
}

extern "C" [[gnu::visibility("default")]] void
texshotStudio(const std::filesystem::path& shaders, const texplorer::view::Pretence& pretence,
              const texplorer::view::ContextChoice& context,
              texplorer::Result<std::unique_ptr<texplorer::screenshot::Studio>>& studio) {
    // Studios may be opened on several threads: the environment is changed before there is a context, and
    // GLEW finds its functions again with each.
    static std::mutex opening;
    static bool first = true;
    const std::scoped_lock lock(opening);
    if (first)
        texplorer::render::setUpDriverCache();
    first = false;
    studio = texplorer::screenshot::openContextStudio(shaders, pretence, context);
}
