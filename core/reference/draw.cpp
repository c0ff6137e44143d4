#include "core/reference/draw.h"

#include "core/base/parallel.h"
#include "core/reference/contributions.h"
#include "core/reference/probe.h"
#include "core/reference/raster/kernel.h"
#include "core/reference/raster/raster.h"
#include "core/reference/raster/scene_triangles.h"
#include "core/reference/shading/pass_state.h"

#include <new>

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
    std::vector<Triangle> triangles; ///< empty between drawings; its memory is for the next one's

    Result<Drawn> draw(const Scene& scene, const ImageSource& images, double time, Viewport viewport,
                       const DrawOptions& options) {
        std::vector<std::string> problems;
        textures.keepOnly(scene);
        const std::vector<PassState> passes =
            passStates(scene, images, time, options.levels, options.anisotropy, textures, problems);
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
        eachTriangle(scene, passes, time, viewport, options.stop, [&](const Triangle& triangle) {
            if (triangles.size() == batch)
                flush(Remaining::More);
            triangles.push_back(triangle);
        });
        flush(Remaining::None);
        if (options.isStopped())
            return stopped();
        return Drawn{std::move(canvas.color), std::move(problems)};
    }
};

namespace {

std::string extents(int width, int height) {
    return std::to_string(width) + " x " + std::to_string(height);
}

Result<void> checkSize(int width, int height) {
    if (width >= 1 && height >= 1 && width <= maxPictureExtent && height <= maxPictureExtent)
        return {};
    return fail(ErrorCode::OutOfRange, "a picture has 1 x 1 to " +
                                           extents(maxPictureExtent, maxPictureExtent) + " pixels, not " +
                                           extents(width, height));
}

} // namespace

ReferenceRenderer::ReferenceRenderer()
    : state_(std::make_unique<State>()) {}
ReferenceRenderer::ReferenceRenderer(ReferenceRenderer&&) noexcept = default;
ReferenceRenderer& ReferenceRenderer::operator=(ReferenceRenderer&&) noexcept = default;
ReferenceRenderer::~ReferenceRenderer() = default;

Result<Drawn> ReferenceRenderer::draw(const Scene& scene, const ImageSource& images, double time, int width,
                                      int height, const DrawOptions& options) {
    if (const Result<void> size = checkSize(width, height); !size)
        return fail(size.error());
    try {
        return state_->draw(scene, images, time, {width, height}, options);
    } catch (const std::bad_alloc&) {
        return fail(ErrorCode::TooLarge, "there is no memory for the scene's textures and a picture of " +
                                             extents(width, height) + " pixels");
    }
}

Result<Explanation> ReferenceRenderer::probe(const Scene& scene, const ImageSource& images, double time,
                                             int width, int height, PixelPlace pixel,
                                             const DrawOptions& options) {
    if (const Result<void> size = checkSize(width, height); !size)
        return fail(size.error());
    if (pixel.x < 0 || pixel.y < 0 || pixel.x >= width || pixel.y >= height)
        return fail(ErrorCode::OutOfRange, "a picture of " + extents(width, height) + " has no pixel " +
                                               std::to_string(pixel.x) + ", " + std::to_string(pixel.y));
    try {
        state_->textures.keepOnly(scene);
        return explainPixel(scene, images, time, {width, height}, pixel, options, state_->textures);
    } catch (const std::bad_alloc&) {
        return fail(ErrorCode::TooLarge, "there is no memory for the scene's textures");
    }
}

Result<Contributions> ReferenceRenderer::contributions(const Scene& scene, const ImageSource& images,
                                                       double time, int width, int height,
                                                       const TexelQuestion& question,
                                                       const DrawOptions& options) {
    if (const Result<void> size = checkSize(width, height); !size)
        return fail(size.error());
    try {
        state_->textures.keepOnly(scene);
        return findContributions(scene, images, time, {width, height}, question, options, state_->textures);
    } catch (const std::bad_alloc&) {
        return fail(ErrorCode::TooLarge, "there is no memory for the scene's textures and a picture of " +
                                             extents(width, height) + " pixels");
    }
}

void ReferenceRenderer::rest() {
    *state_ = State();
}

Result<Drawn> drawReference(const Scene& scene, const ImageSource& images, double time, int width, int height,
                            const DrawOptions& options) {
    return ReferenceRenderer().draw(scene, images, time, width, height, options);
}

} // namespace texplorer::reference
