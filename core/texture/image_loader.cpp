#include "core/texture/image_loader.h"

#include "core/base/file_io.h"
#include "core/codec/registry.h"
#include "core/image/thumbnail.h"
#include "core/texture/image_budget.h"
#include "core/s3tc/surface_pixels.h"

#include <algorithm>
#include <condition_variable>
#include <deque>
#include <mutex>
#include <new>
#include <stop_token>
#include <system_error>
#include <thread>
#include <utility>

namespace texplorer {

namespace {

using Content = ImageLoader::Content;
using Wanted = ImageLoader::Wanted;

constexpr DecodeLimits thumbnailLimits{
    .maxExtent = 8192, .maxPixels = std::size_t{32} << 20, .maxBytes = std::size_t{256} << 20};

Content dissectFile(Bytes bytes) {
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

/// `decoding` is called when the file is read.
Result<Content> work(const std::filesystem::path& path, Wanted wanted, std::size_t left,
                     const ReadObserver& observer, const std::function<void()>& decoding) {
    const std::size_t most =
        wanted == Wanted::Thumbnail ? ImageLoader::thumbnailFileBytes : defaultMaxFileBytes;
    try {
        Result<Bytes> bytes = readFile(path, most, observer);
        if (!bytes)
            return fail(bytes.error());
        if (decoding)
            decoding();
        if (wanted == Wanted::Anatomy)
            return dissectFile(std::move(*bytes));
        const bool small = wanted == Wanted::Thumbnail;
        Result<TextureImage> texture =
            small ? decodeTexture(*bytes, thumbnailLimits) : decodeWithin(*bytes, left);
        if (!texture)
            return fail(texture.error().code, texture.error().message, path.string());
        if (small)
            return thumbnailOf(uprightImage(std::move(*texture)), ImageLoader::thumbnailExtent);
        return std::make_shared<const TextureImage>(std::move(*texture));
    } catch (const std::bad_alloc&) {
        return fail(ErrorCode::TooLarge, "there is no memory for what it holds", path.string());
    }
}

} // namespace

struct ImageLoader::State {
    explicit State(std::function<void()> onNews)
        : wake(std::move(onNews)) {}

    struct Job {
        Ticket ticket;
        std::filesystem::path path;
        Wanted wanted;
    };

    std::function<void()> wake;

    mutable std::mutex mutex; // guards what follows
    std::condition_variable_any arrived;
    mutable std::condition_variable finished;
    std::deque<Job> waiting;
    std::optional<Progress> current;
    bool dropsCurrent = false; // what is worked on was cancelled
    std::vector<Loaded> done;
    Ticket lastTicket = 0;

    std::jthread thread; // last: it ends before the rest does

    void run(const std::stop_token& stop);
    void process(const Job& job, const std::stop_token& stop);
    [[nodiscard]] std::size_t left() const;
    void tell() const {
        if (wake)
            wake();
    }
};

void ImageLoader::State::run(const std::stop_token& stop) {
    for (;;) {
        Job job;
        {
            std::unique_lock lock(mutex);
            if (!arrived.wait(lock, stop, [this] { return !waiting.empty(); }) || stop.stop_requested())
                return;
            job = std::move(waiting.front());
            waiting.pop_front();
            current = Progress{job.ticket, job.path, Step::Reading};
            dropsCurrent = false;
        }
        process(job, stop);
        finished.notify_all();
        tell();
    }
}

/// Of sceneImageBytes, beside the textures that are waiting to be taken.
std::size_t ImageLoader::State::left() const {
    const std::scoped_lock lock(mutex);
    std::size_t waitingBytes = 0;
    for (const Loaded& each : done)
        if (each.content)
            if (const auto* texture = std::get_if<std::shared_ptr<const TextureImage>>(&*each.content))
                waitingBytes += byteCount(**texture);
    return sceneImageBytes - std::min(sceneImageBytes, waitingBytes);
}

void ImageLoader::State::process(const Job& job, const std::stop_token& stop) {
    const auto reading = [&](std::size_t bytes, std::size_t total) {
        {
            const std::scoped_lock lock(mutex);
            if (dropsCurrent || stop.stop_requested())
                return false;
            current->bytesRead = bytes;
            current->fileBytes = total;
        }
        tell();
        return true;
    };
    const auto decoding = [&] {
        {
            const std::scoped_lock lock(mutex);
            current->step = Step::Decoding;
        }
        tell();
    };
    Result<Content> content = work(job.path, job.wanted, left(), reading, decoding);
    const std::scoped_lock lock(mutex);
    if (!dropsCurrent)
        done.push_back({job.ticket, job.path, std::move(content)});
    current.reset();
}

ImageLoader::ImageLoader(std::function<void()> wake)
    : state_(std::make_unique<State>(std::move(wake))) {}

ImageLoader::~ImageLoader() = default;

ImageLoader::Ticket ImageLoader::load(std::filesystem::path path, Wanted wanted) {
    Ticket ticket = 0;
    {
        const std::scoped_lock lock(state_->mutex);
        ticket = ++state_->lastTicket;
        state_->waiting.push_back({ticket, std::move(path), wanted});
    }
    if (!state_->thread.joinable()) {
        try {
            state_->thread =
                std::jthread([state = state_.get()](const std::stop_token& stop) { state->run(stop); });
        } catch (const std::system_error&) { // no thread to be had: slower, but it works
            const std::scoped_lock lock(state_->mutex);
            const State::Job job = std::move(state_->waiting.back());
            state_->waiting.pop_back();
            state_->done.push_back({job.ticket, job.path, loadNow(job.path, job.wanted)});
            return ticket;
        }
    }
    state_->arrived.notify_one();
    return ticket;
}

void ImageLoader::cancel(Ticket ticket) {
    {
        const std::scoped_lock lock(state_->mutex);
        std::erase_if(state_->waiting, [&](const State::Job& job) { return job.ticket == ticket; });
        std::erase_if(state_->done, [&](const Loaded& loaded) { return loaded.ticket == ticket; });
        if (state_->current && state_->current->ticket == ticket)
            state_->dropsCurrent = true;
    }
    state_->finished.notify_all();
}

void ImageLoader::cancelAll() {
    {
        const std::scoped_lock lock(state_->mutex);
        state_->waiting.clear();
        state_->done.clear();
        state_->dropsCurrent = state_->current.has_value();
    }
    state_->finished.notify_all();
}

std::vector<ImageLoader::Loaded> ImageLoader::take() {
    const std::scoped_lock lock(state_->mutex);
    return std::exchange(state_->done, {});
}

std::optional<ImageLoader::Progress> ImageLoader::progress() const {
    const std::scoped_lock lock(state_->mutex);
    if (state_->current && !state_->dropsCurrent)
        return state_->current;
    if (state_->waiting.empty())
        return std::nullopt;
    return Progress{state_->waiting.front().ticket, state_->waiting.front().path};
}

void ImageLoader::wait() const {
    std::unique_lock lock(state_->mutex);
    state_->finished.wait(
        lock, [this] { return state_->waiting.empty() && (!state_->current || state_->dropsCurrent); });
}

Result<ImageLoader::Content> loadNow(const std::filesystem::path& path, ImageLoader::Wanted wanted) {
    return work(path, wanted, sceneImageBytes, {}, {});
}

} // namespace texplorer
