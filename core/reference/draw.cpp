#include "texplorer/reference/draw.h"

#include "texplorer/base/parallel.h"
#include "texplorer/reference/contributions.h"
#include "texplorer/reference/level_map.h"
#include "texplorer/reference/light_depth.h"
#include "texplorer/reference/probe.h"
#include "texplorer/reference/raster/kernel.h"
#include "texplorer/reference/raster/raster.h"
#include "texplorer/reference/raster/scene_triangles.h"
#include "texplorer/reference/shading/pass_state.h"
#include "texplorer/scene/params/scene_at.h"

#include <fmt/core.h>

#include <new>
#include <utility>

namespace texplorer::reference {

namespace {

/// So many triangles are set up before they are drawn: enough to keep the tiles busy, few enough for the
/// memory that they take.
constexpr std::size_t batch = 8192;

tl::unexpected<Error> stopped() {
    return fail(ErrorCode::Cancelled, "the drawing was stopped");
}

} // namespace

struct ReferenceRenderer::State {
    TextureStore textures;
    LightDepths lightDepths;
    DrawRequest seen;                ///< the scene at that time, with the light's view
    std::vector<Triangle> triangles; ///< empty between drawings; its memory is for the next one's

    /// The request with the scene evaluated at its time, and with the light's view if a texture uses it; the
    /// same request if both change nothing.
    const DrawRequest& standing(const DrawRequest& request, const DrawOptions& options) {
        const StandingScene scene(request.scene, request.time);
        const bool lit = showsLightDepths(*scene);
        if (!lit && &*scene == &request.scene)
            return request;
        seen = {*scene,        request.images,     request.time,
                request.width, request.height,     request.anisotropy,
                request.rho,   request.cornerBits, request.zeroSwitchOver};
        if (lit)
            seen.images = lightDepths.addedTo(request.images, seen.scene, request.time, options.stop);
        return seen;
    }

    Result<Frame> draw(const DrawRequest& request, const DrawOptions& options) {
        const Scene& scene = request.scene;
        const Viewport viewport{request.width, request.height, request.cornerBits};
        std::vector<Sentence> problems;
        textures.keepOnly(scene);
        const std::vector<PassState> passes = passStates(scene, request.images, request.time, options.levels,
                                                         request.sampling(), textures, problems);
        if (options.isStopped())
            return stopped();
        Canvas canvas(viewport, scene.view.background);
        const Kernel* kernel = options.kernel ? options.kernel : kernels().front();
        if (options.literal)
            kernel = nullptr;
        const unsigned threads = options.threads == 0 ? processorThreads() : options.threads;
        triangles.clear(); // of a drawing that ran out of memory
        const auto flush = [&](Remaining remaining) {
            rasterize(triangles, canvas, remaining, kernel, threads, options.stop);
            triangles.clear();
        };
        eachTriangle(scene, passes, request.time, viewport, options.stop, [&](const Triangle& triangle) {
            if (triangles.size() == batch)
                flush(Remaining::More);
            triangles.push_back(triangle);
        });
        flush(Remaining::None);
        if (options.isStopped())
            return stopped();
        return Frame{std::move(canvas.color), std::move(problems)};
    }
};

namespace {

std::string extents(int width, int height) {
    return fmt::format("{} × {}", width, height);
}

Result<void> checkSize(const DrawRequest& request) {
    const auto [width, height] = std::pair(request.width, request.height);
    if (width >= 1 && height >= 1 && width <= maxPictureExtent && height <= maxPictureExtent)
        return {};
    return fail(ErrorCode::OutOfRange,
                Sentence("a picture has 1 × 1 to {0} pixels, not {1}",
                         extents(maxPictureExtent, maxPictureExtent), extents(width, height)));
}

tl::unexpected<Error> noMemory(const DrawRequest& request) {
    return fail(ErrorCode::TooLarge,
                Sentence("not enough memory for the scene's textures and a picture of {0} pixels",
                         extents(request.width, request.height)));
}

} // namespace

ReferenceRenderer::ReferenceRenderer()
    : state_(std::make_unique<State>()) {}
ReferenceRenderer::ReferenceRenderer(ReferenceRenderer&&) noexcept = default;
ReferenceRenderer& ReferenceRenderer::operator=(ReferenceRenderer&&) noexcept = default;
ReferenceRenderer::~ReferenceRenderer() = default;

Result<Frame> ReferenceRenderer::draw(const DrawRequest& request, const DrawOptions& options) {
    if (const Result<void> size = checkSize(request); !size)
        return fail(size.error());
    try {
        return state_->draw(state_->standing(request, options), options);
    } catch (const std::bad_alloc&) {
        return noMemory(request);
    }
}

Result<Explanation> ReferenceRenderer::probe(const DrawRequest& request, PixelPlace pixel,
                                             const DrawOptions& options) {
    if (const Result<void> size = checkSize(request); !size)
        return fail(size.error());
    if (pixel.x < 0 || pixel.y < 0 || pixel.x >= request.width || pixel.y >= request.height)
        return fail(ErrorCode::OutOfRange,
                    Sentence("a picture of {0} has no pixel {1}, {2}", extents(request.width, request.height),
                             pixel.x, pixel.y));
    try {
        const DrawRequest& standing = state_->standing(request, options);
        state_->textures.keepOnly(standing.scene);
        return explainPixel(standing, pixel, options, state_->textures);
    } catch (const std::bad_alloc&) {
        return fail(ErrorCode::TooLarge, "not enough memory for the scene's textures");
    }
}

Result<Contributions> ReferenceRenderer::contributions(const DrawRequest& request,
                                                       const TexelQuestion& question,
                                                       const DrawOptions& options) {
    if (const Result<void> size = checkSize(request); !size)
        return fail(size.error());
    try {
        const DrawRequest& standing = state_->standing(request, options);
        state_->textures.keepOnly(standing.scene);
        return findContributions(standing, question, options, state_->textures);
    } catch (const std::bad_alloc&) {
        return noMemory(request);
    }
}

Result<LevelMap> ReferenceRenderer::levels(const DrawRequest& request, const LevelQuestion& question,
                                           const DrawOptions& options) {
    if (const Result<void> size = checkSize(request); !size)
        return fail(size.error());
    try {
        const DrawRequest& standing = state_->standing(request, options);
        state_->textures.keepOnly(standing.scene);
        return findLevels(standing, question, options, state_->textures);
    } catch (const std::bad_alloc&) {
        return noMemory(request);
    }
}

void ReferenceRenderer::rest() {
    *state_ = State();
}

Result<Frame> drawReference(const DrawRequest& request, const DrawOptions& options) {
    return ReferenceRenderer().draw(request, options);
}

} // namespace texplorer::reference
