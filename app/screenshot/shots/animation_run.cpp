#include "app/screenshot/shots/animation_run.h"

#include "app/animation/make_encoder.h"
#include "app/screenshot/gl/picture_texts.h"
#include "app/screenshot/output/interrupts.h"
#include "app/screenshot/output/long_work.h"
#include "app/screenshot/output/messages.h"
#include "app/screenshot/shots/drawing.h"
#include "texplorer/base/tried.h"

#include <fmt/core.h>

#include <condition_variable>
#include <map>
#include <mutex>
#include <optional>
#include <utility>

namespace texplorer::screenshot {
namespace {

constexpr std::size_t maxWaiting = 4; // pictures that are drawn and not encoded

/// Brings pictures that come from several threads into their order, and encodes them on whichever thread has
/// the next one, while the others draw.
class EncodingQueue {
public:
    EncodingQueue(const AnimationRun& run, const LongWork& work)
        : run_(run)
        , stop_(work.stopToken()) {}

    /// From any thread. Waits where too many pictures are ahead of the one that comes next.
    void take(const DrawnShot& drawn) {
        std::unique_lock lock(mutex_);
        if (!drawn.shot) {
            lost_ = true;
            moved_.notify_all();
            return;
        }
        if (drawn.index == 0 && run_.withTexts)
            facts_ = factsOf(drawn.request, *drawn.shot);
        waiting_.emplace(drawn.index, std::move(drawn.shot->frame.image));
        if (!encoding_)
            encodeWaiting(lock);
        moved_.wait(lock, stop_, [&] { return waiting_.size() <= maxWaiting || !goesOn(); });
    }

    [[nodiscard]] bool goesOnLocked() const {
        const std::scoped_lock lock(mutex_);
        return goesOn();
    }

    /// When no more pictures come: the file. The error of whoever failed; none where a picture couldn't be
    /// drawn, which has been said.
    [[nodiscard]] std::optional<Result<Bytes>> finish() {
        const std::scoped_lock lock(mutex_);
        if (failure_)
            return Result<Bytes>(tl::unexpected(*failure_));
        if (lost_ || next_ < run_.durations.size())
            return std::nullopt;
        return encoder_->finish();
    }

private:
    [[nodiscard]] bool goesOn() const { return !lost_ && !failure_; }

    void encodeWaiting(std::unique_lock<std::mutex>& lock) {
        encoding_ = true;
        while (goesOn() && !stop_.stop_requested()) {
            const auto found = waiting_.find(next_);
            if (found == waiting_.end())
                break;
            const Image image = std::move(found->second);
            waiting_.erase(found);
            lock.unlock();
            const Result<void> added = tried({"not enough memory for the animation", "it can't be encoded"},
                                             [&]() -> Result<void> { return encode(image); });
            lock.lock();
            ++next_;
            if (!added)
                failure_ = added.error();
            moved_.notify_all();
        }
        encoding_ = false;
    }

    /// Only the thread that encodes is here, and nobody else changes `next_`.
    Result<void> encode(const Image& image) {
        if (!encoder_) {
            animation::Settings settings = run_.settings;
            if (facts_)
                settings.texts = textsOf(*facts_);
            auto made = animation::makeEncoder(run_.format, settings);
            if (!made)
                return fail(made.error());
            encoder_ = *std::move(made);
        }
        return encoder_->add(image, run_.durations[next_]);
    }

    const AnimationRun& run_;
    const std::stop_token stop_;
    std::unique_ptr<animation::Encoder> encoder_; ///< with the first picture, whose texts it has
    std::optional<PictureFacts> facts_;
    mutable std::mutex mutex_; // guards what follows, and the two above until the first picture is there
    std::condition_variable_any moved_;
    std::map<std::size_t, Image> waiting_;
    std::size_t next_ = 0; ///< to be encoded
    bool encoding_ = false;
    bool lost_ = false; ///< a picture couldn't be drawn
    std::optional<Error> failure_;
};

/// What sentences call each picture.
std::vector<std::string> namesOf(const ShotList& list) {
    std::vector<std::string> names;
    for (std::size_t i = 0; i < list.count(); ++i)
        names.push_back(fmt::format("picture {} of {}", i + 1, list.count()));
    return names;
}

} // namespace

ExitCode drawAnimation(AnimationRun run) {
    LongWork work("texshot: drawing");
    EncodingQueue queue(run, work);
    const std::vector<std::string> names = namesOf(run.list);
    const DrawingEnd end = drawList({.list = run.list,
                                     .names = names,
                                     .common = run.common,
                                     .work = work,
                                     .take = [&](const DrawnShot& drawn) { queue.take(drawn); },
                                     .goesOn = [&] { return queue.goesOnLocked(); }});
    std::optional<Result<Bytes>> file;
    if (!work.stopToken().stop_requested() && !end.unopened)
        file = queue.finish();
    work.finish();
    for (const Error& each : end.warnings)
        warn(each);
    if (work.stopToken().stop_requested())
        return complainInterrupted();
    if (end.unopened)
        return complain(*end.unopened);
    if (!file)
        return failure;
    if (!*file)
        return complain(file->error());
    if (const Result<void> written = run.output.write(**file); !written)
        return complain(written.error());
    return success;
}

} // namespace texplorer::screenshot
