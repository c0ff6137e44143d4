#include "texplorer/texture/image_loader.h"

#include "texplorer/base/worker.h"
#include "texplorer/codec/image_file.h"
#include "texplorer/codec/registry.h"
#include "texplorer/files/file_io.h"
#include "texplorer/image/thumbnail.h"
#include "texplorer/s3tc/surface_pixels.h"

#include <algorithm>
#include <utility>

namespace texplorer {

namespace {

using Content = ImageLoader::Content;
using Wanted = ImageLoader::Wanted;

DecodeLimits thumbnailLimits(const std::stop_token& stop) {
    return {.maxExtent = 8192,
            .maxPixels = std::size_t{32} << 20,
            .maxBytes = std::size_t{256} << 20,
            .stop = &stop};
}

constexpr FailureWords loadingFailure{N_("not enough memory for what it holds"), N_("can't be loaded")};

Result<Content> readMeshes(const std::filesystem::path& path, std::size_t left, const ReadObserver& observer,
                           const std::function<void()>& decoding) {
    const Result<Bytes> bytes = readFile(path, maxObjBytes, observer);
    if (!bytes)
        return fail(bytes.error());
    if (decoding)
        decoding();
    Result<MeshFile> meshes = meshFileIn(*bytes, path);
    if (!meshes)
        return fail(meshes.error());
    if (byteCount(*meshes) > left)
        return fail(beyondBudget(byteCount(*meshes), left));
    return std::make_shared<const MeshFile>(*std::move(meshes));
}

/// `decoding` is called when the file is read.
Result<Content> work(const std::filesystem::path& path, Wanted wanted, std::size_t left,
                     const std::stop_token& stop, const ReadObserver& observer,
                     const std::function<void()>& decoding) {
    const std::size_t maxBytes =
        wanted == Wanted::Thumbnail ? ImageLoader::thumbnailFileBytes : defaultMaxFileBytes;
    Result<Content> content = tried(loadingFailure, [&]() -> Result<Content> {
        if (wanted == Wanted::Texture && isObjName(path))
            return readMeshes(path, left, observer, decoding);
        Result<Bytes> bytes = readImageFile(path, maxBytes, observer);
        if (!bytes)
            return fail(bytes.error());
        if (decoding)
            decoding();
        if (wanted == Wanted::Anatomy)
            return dissectFile(std::move(*bytes));
        const bool small = wanted == Wanted::Thumbnail;
        Result<TextureImage> texture = small ? decodeTexture(*bytes, thumbnailLimits(stop))
                                             : decodeWithin(*bytes, left, Decoding::Pixels, &stop);
        if (!texture)
            return fail(texture.error());
        if (small)
            return thumbnailOf(uprightImage(std::move(*texture)), ImageLoader::thumbnailExtent);
        return std::make_shared<const TextureImage>(std::move(*texture));
    });
    if (!content)
        content.error().where = inFile(path.string());
    return content;
}

} // namespace

std::shared_ptr<const DissectedFile> dissectFile(Bytes bytes) {
    auto file = std::make_shared<DissectedFile>();
    file->anatomy = dissect(bytes);
    file->fileBytes = bytes.size();
    if (const auto texture = decodeTexture(bytes); !texture)
        file->problem = texture.error().message;
    if (bytes.size() > DissectedFile::keptBytes) {
        bytes.resize(DissectedFile::keptBytes);
        bytes.shrink_to_fit();
    }
    file->bytes = std::move(bytes);
    return file;
}

struct ImageLoader::State {
    explicit State(std::function<void()> wake)
        : worker(
              {When::WhenReady, JobOrder::Queue, loadingFailure, std::move(wake)},
              [this](const Loading::Task& task) { return load(task); },
              [](const Job& job, Error error) {
                  error.where = inFile(job.path.string());
                  return Loaded{job.ticket, job.path, fail(std::move(error))};
              }) {}

    struct Job {
        Ticket ticket = 0;
        std::filesystem::path path;
        Wanted wanted = Wanted::Texture;
    };
    using Loading = Worker<Job, Loaded, Progress>;

    Ticket lastTicket = 0; // of the thread that asks
    Loading worker;

    std::optional<Loaded> load(const Loading::Task& task) const;
    [[nodiscard]] std::size_t left() const;
};

/// What is left of sceneImageBytes next to the textures that were not taken yet.
std::size_t ImageLoader::State::left() const {
    std::size_t waitingBytes = 0;
    worker.look([&](const Loaded& each) {
        if (!each.content)
            return;
        if (const auto* texture = std::get_if<std::shared_ptr<const TextureImage>>(&*each.content))
            waitingBytes += byteCount(**texture);
        else if (const auto* meshes = std::get_if<std::shared_ptr<const MeshFile>>(&*each.content))
            waitingBytes += byteCount(**meshes);
    });
    return sceneImageBytes - std::min(sceneImageBytes, waitingBytes);
}

std::optional<ImageLoader::Loaded> ImageLoader::State::load(const Loading::Task& task) const {
    const Job& job = task.job();
    Progress progress{job.ticket, job.path, Step::Reading};
    const auto reading = [&](std::size_t bytes, std::size_t total) {
        if (task.stop().stop_requested())
            return false;
        progress.bytesRead = bytes;
        progress.fileBytes = total;
        task.report(progress);
        return true;
    };
    const auto decoding = [&] {
        progress.step = Step::Decoding;
        task.report(progress);
    };
    return Loaded{job.ticket, job.path, work(job.path, job.wanted, left(), task.stop(), reading, decoding)};
}

ImageLoader::ImageLoader(std::function<void()> wake)
    : state_(std::make_unique<State>(std::move(wake))) {}

ImageLoader::~ImageLoader() = default;

ImageLoader::Ticket ImageLoader::load(std::filesystem::path path, Wanted wanted) {
    const Ticket ticket = ++state_->lastTicket;
    Progress waiting{ticket, path};
    state_->worker.ask({ticket, std::move(path), wanted}, std::move(waiting));
    return ticket;
}

void ImageLoader::cancel(Ticket ticket) {
    const auto isIt = [ticket](const auto& each) { return each.ticket == ticket; };
    state_->worker.drop(isIt);
    state_->worker.discard(isIt);
}

std::vector<ImageLoader::Loaded> ImageLoader::take() {
    return state_->worker.take();
}

std::optional<ImageLoader::Progress> ImageLoader::progress() const {
    return state_->worker.progress();
}

void ImageLoader::wait() const {
    state_->worker.wait();
}

Result<ImageLoader::Content> loadNow(const std::filesystem::path& path, ImageLoader::Wanted wanted,
                                     std::size_t left) {
    return work(path, wanted, left, {}, {}, {});
}

} // namespace texplorer
