// The functions that page/windowless.mjs calls in a Web Worker: it draws pictures of the reference for
// PageDrawing, or makes a file for PageWriting. A text is given in memory that `allocate` has returned and
// that the called function frees.

#include "app/ui/services/file_writing.h"
#include "app/web/browser.h"
#include "app/web/level_work.h"
#include "app/web/sent_sentences.h"
#include "texplorer/base/tried.h"
#include "texplorer/reference/draw.h"
#include "texplorer/scene/params/json.h"

#include <chrono>
#include <cstdlib>
#include <filesystem>

namespace {

using namespace texplorer;

ImageSource images;
reference::ReferenceRenderer renderer;

Result<Frame> frameOf(const std::string& text, double time, int width, int height, unsigned anisotropy,
                      unsigned rho) {
    Result<Scene> scene = parseScene(text);
    if (!scene)
        return fail(scene.error());
    static_cast<void>(images.load(*scene)); // the renderer says which files are missing
    const reference::DrawRequest request{.scene = *std::move(scene),
                                         .images = images,
                                         .time = time,
                                         .width = width,
                                         .height = height,
                                         .anisotropy = static_cast<reference::AnisotropyMethod>(anisotropy),
                                         .rho = static_cast<reference::RhoMethod>(rho)};
    return renderer.draw(request, {.levels = web::levelWork()});
}

} // namespace

/// Files have changed: they are in the folder /given.
TEXPLORER_EXPORT(filesChanged) void filesChanged() {
    std::filesystem::current_path("/given");
    images = {};
}

TEXPLORER_EXPORT(drawPicture)
void drawPicture(char* text, std::size_t length, double time, int width, int height, unsigned anisotropy,
                 unsigned rho) {
    const std::string scene(text, length);
    std::free(text);
    constexpr FailureWords failure{N_("not enough memory for the picture"), N_("the picture can't be drawn")};
    const auto begin = std::chrono::steady_clock::now();
    const Result<Frame> frame =
        tried(failure, [&] { return frameOf(scene, time, width, height, anisotropy, rho); });
    const std::chrono::duration<double, std::milli> elapsed = std::chrono::steady_clock::now() - begin;
    const Image none;
    const Image& image = frame ? frame->image : none;
    const std::string problems =
        web::sentSentences(frame ? frame->problems : std::vector{describe(frame.error())});
    web::browser::pictureDrawn(image.pixels.data(), image.width, image.height, elapsed.count(),
                               problems.data(), web::lengthOf(problems));
}

/// `order` is that of the program of which this one is a copy.
TEXPLORER_EXPORT(makeFile) void makeFile(const ui::FileOrder* order) {
    constexpr FailureWords failure{N_("not enough memory for it"), N_("it can't be created")};
    const Result<ui::MadeFile> made = tried(failure, [order] {
        return order->make({.levels = web::levelWork(), .report = web::browser::fileProgressed});
    });
    const std::string said = web::sentSentences({made ? made->remark : describe(made.error())});
    const Bytes none;
    const Bytes& bytes = made ? made->bytes : none;
    web::browser::fileMade(made.has_value(), bytes.data(), web::lengthOf(bytes), said.data(),
                           web::lengthOf(said));
}
