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
#include "texplorer/reference/drawn_pictures.h"

#include <fmt/core.h>

#include <functional>
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
    DrawnPictures pictures;
    std::vector<Sentence> pictureProblems; ///< about what could not be drawn in them
    DrawRequest seen;                      ///< what `standing` returned
    std::vector<Triangle> triangles;       ///< empty between drawings; its memory is for the next one's

    /// The request with the scene evaluated at its time, without passes that draw in pictures, and with the
    /// images that are drawn for its textures: the light's view and pictures; the same request if all of this
    /// changes nothing.
    Result<std::reference_wrapper<const DrawRequest>> standing(const DrawRequest& request,
                                                               const DrawOptions& options) {
        const StandingScene scene(request.scene, request.time);
        textures.keepOnly(*scene);
        const bool pictured = hasPictures(*scene) || !shownPictures(*scene).empty();
        if (!pictured)
            pictureProblems.clear();
        if (!pictured && !showsLightDepths(*scene) && &*scene == &request.scene)
            return request;
        ImageSource images = lightDepths.addedTo(request.images, *scene, request.time, options.stop);
        if (pictured) {
            std::vector<Sentence> before = std::exchange(pictureProblems, {});
            bool isNew = false;
            const auto drawPicture = [&](const Scene& picture, const ImageSource& known, double time,
                                         int size) -> Result<Image> {
                DrawRequest square = with(request, picture, known, time);
                square.width = square.height = size;
                Result<Frame> drawn = draw(square, options);
                if (!drawn)
                    return fail(drawn.error());
                pictureProblems = std::move(drawn->problems); // and those of the pictures before it
                isNew = true;
                return std::move(drawn->image);
            };
            Result<ImageSource> added = pictures.addedTo(images, request.scene, request.time, drawPicture);
            if (!added)
                return fail(added.error());
            images = std::move(*added);
            if (!isNew)
                pictureProblems = std::move(before);
        }
        seen = with(request, pictured ? picturedScene(*scene, 0) : *scene, std::move(images), request.time);
        return seen;
    }

    static DrawRequest with(const DrawRequest& request, Scene scene, ImageSource images, double time) {
        return {std::move(scene), std::move(images),  time,
                request.width,    request.height,     request.anisotropy,
                request.rho,      request.cornerBits, request.zeroSwitchOver};
    }

    Result<Frame> draw(const DrawRequest& request, const DrawOptions& options) {
        const Scene& scene = request.scene;
        const Viewport viewport{request.width, request.height, request.cornerBits};
        std::vector<Sentence> problems = pictureProblems;
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
        const auto standing = state_->standing(request, options);
        return standing ? state_->draw(*standing, options) : fail(standing.error());
    } catch (const std::bad_alloc&) {
        return noMemory(request);
    }
}

Result<ImageSource> ReferenceRenderer::drawnImages(const DrawRequest& request, const DrawOptions& options) {
    try {
        const auto standing = state_->standing(request, options);
        return standing ? Result<ImageSource>(standing->get().images) : fail(standing.error());
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
        const auto found = state_->standing(request, options);
        if (!found)
            return fail(found.error());
        const DrawRequest& standing = *found;
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
        const auto found = state_->standing(request, options);
        if (!found)
            return fail(found.error());
        const DrawRequest& standing = *found;
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
        const auto found = state_->standing(request, options);
        if (!found)
            return fail(found.error());
        const DrawRequest& standing = *found;
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
