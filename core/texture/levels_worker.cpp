#include "texplorer/texture/levels_worker.h"

#include "texplorer/image/convert.h"
#include "texplorer/image/thumbnail.h"
#include "texplorer/s3tc/surface_pixels.h"
#include "texplorer/texture/late_flip.h"
#include "texplorer/texture/target_image.h"

#include <algorithm>
#include <cstring>
#include <deque>
#include <filesystem>
#include <utility>

namespace texplorer {

namespace {

constexpr std::size_t quickTexels = std::size_t{256} * 256;

constexpr std::size_t maxEntries = 32;

constexpr FailureWords levelsFailure{N_("not enough memory for the statistics of its levels"),
                                     N_("its levels can't be made")};

Sentence nameOf(const Texture& settings) {
    switch (settings.source) {
    case SourceKind::Pattern:
        break;
    case SourceKind::File:
        return ProperName{std::filesystem::path(settings.file).filename().string()};
    case SourceKind::LightDepth:
    case SourceKind::Picture:
        return rowOf(settings.source).label;
    }
    return rowOf(settings.pattern).label;
}

std::optional<BlockFormat> formatOf(const std::vector<TextureLevel>& levels) {
    if (levels.empty())
        return std::nullopt;
    const auto* blocks = std::get_if<BlockImage>(&*levels.front().surface);
    return blocks ? std::optional(blocks->format) : std::nullopt;
}

PreparedLevels make(const LevelsRequest& request, const LevelWork& work) {
    if (!request.pictures.base)
        return fail(ErrorCode::NotFound, "the image is not loaded");
    return prepareLevels(request.settings, request.pictures, request.target, work);
}

using Thumbnail = std::shared_ptr<const Image>;

/// What a person needs to see of what was done to a picture: upright, of a volume the middle slice.
Thumbnail smallOf(const Image& image, bool topFirst) {
    constexpr int extent = LevelsSummary::thumbnailExtent;
    Image small = thumbnailOf(image.depth > 1 ? imageForTarget(image, Target::Texture2D) : image, extent);
    if (topFirst)
        flipVertically(small);
    return std::make_shared<const Image>(std::move(small));
}

/// Every nth texel along both axes, so that there are at most twice as many as are shown: an average of all
/// of a large level would hold its upload up.
Image thinned(Image image) {
    constexpr int maxExtent = 2 * LevelsSummary::levelExtent;
    const int step = (std::max(image.width, image.height) + maxExtent - 1) / maxExtent;
    if (step <= 1)
        return image;
    Image thin =
        Image::uninitialised(image.format, (image.width + step - 1) / step, (image.height + step - 1) / step);
    for (int y = 0; y < thin.height; ++y) {
        for (int x = 0; x < thin.width; ++x)
            std::ranges::copy(std::as_const(image).at(x * step, y * step), thin.at(x, y).begin());
    }
    return thin;
}

/// Rgba8, at most levelExtent a side. What has alpha alone is white that fades, as in every thumbnail.
Image levelPicture(const Image& level) {
    if (level.format == PixelFormat::Alpha8 ||
        std::max(level.width, level.height) > LevelsSummary::levelExtent)
        return thumbnailOf(level, LevelsSummary::levelExtent);
    if (level.format == PixelFormat::Rgba8)
        return level;
    Image picture = Image::uninitialised(PixelFormat::Rgba8, level.width, level.height);
    for (int y = 0; y < level.height; ++y) {
        for (int x = 0; x < level.width; ++x) {
            const auto color = rgbaOf(level.format, level.at(x, y).data());
            std::memcpy(picture.at(x, y).data(), color.data(), color.size());
        }
    }
    return picture;
}

/// A level's surface as the texture has it; what is left to do about a picture that is upside down is done.
std::vector<std::pair<int, Thumbnail>> levelPictures(const LevelsRequest& request,
                                                     const TextureLevels& levels, int face) {
    std::vector<std::pair<int, Thumbnail>> pictures;
    const bool topFirst = isTopFirst(levels, request.target);
    for (const TextureLevel& level : levels.levels) {
        if (level.face != face)
            continue;
        Image whole = toImage(level.surface);
        if (whole.depth > 1)
            whole = imageForTarget(whole, Target::Texture2D);
        Image small = levelPicture(thinned(std::move(whole)));
        if (topFirst)
            flipVertically(small);
        pictures.emplace_back(level.number, std::make_shared<const Image>(std::move(small)));
    }
    return pictures;
}

std::vector<std::pair<int, Thumbnail>> givenPictures(const LevelsRequest& request,
                                                     const TextureLevels& levels) {
    std::vector<std::pair<int, Thumbnail>> pictures;
    if (request.settings.mipmaps != MipPolicy::Given)
        return pictures;
    const bool topFirst = isTopFirst(levels, request.target);
    for (const TextureLevel& level : levels.levels) {
        if (level.face == 0)
            pictures.emplace_back(level.number, smallOf(toImage(level.surface), topFirst));
    }
    return pictures;
}

std::shared_ptr<const LevelsSummary> summarise(const LevelsRequest& request, const PreparedLevels& levels,
                                               std::vector<Thumbnail> steps = {}) {
    auto summary = std::make_shared<LevelsSummary>();
    if (!levels) {
        summary->problem = describe(levels.error());
        return summary;
    }
    summary->report = reportOn(*levels);
    summary->byDriver = levels->driverFormat.has_value();
    summary->compressed = summary->byDriver ? levels->driverFormat : formatOf(levels->levels);
    summary->notes = levels->notes;
    summary->steps = std::move(steps);
    summary->pictures = givenPictures(request, *levels);
    summary->levels = levelPictures(request, *levels, 0);
    for (std::size_t i = 0; request.target == Target::CubeMap && i < summary->otherFaces.size(); ++i)
        summary->otherFaces[i] = levelPictures(request, *levels, static_cast<int>(i) + 1);
    return summary;
}

/// The driver's levels, measured against what it was given. `known` is what there was to say before.
std::shared_ptr<const LevelsSummary>
measure(const PreparedLevels& from, const std::vector<TextureLevel>& made, const LevelsSummary& known) {
    auto summary = std::make_shared<LevelsSummary>(known);
    MipChain source;
    for (const TextureLevel& level : from->levels) {
        const Image* image = std::get_if<Image>(&*level.surface);
        source.push_back(image ? *image : Image{});
    }
    summary->report = reportOn(made, source);
    summary->byDriver = true;
    summary->compressed = formatOf(made);
    summary->notes = from->notes;
    return summary;
}

} // namespace

bool isQuick(const LevelsRequest& request) {
    const auto texelsOf = [](const TexturePictures::Picture& picture) {
        if (!picture || picture->surfaces.empty())
            return std::size_t{0};
        const Surface& base = picture->surfaces.front();
        const auto extent = [](int value) { return static_cast<std::size_t>(std::max(value, 1)); };
        return extent(widthOf(base)) * extent(heightOf(base)) * extent(depthOf(base));
    };
    const TexturePictures& pictures = request.pictures;
    std::size_t texels = texelsOf(pictures.base);
    if (texels > 0 && request.settings.compression == Compression::Cached)
        return false;
    texels *= 1 + request.settings.preparation.size();
    if (request.settings.mipCoverage > 0)
        texels *= 16; // each level is tried with many factors
    for (const auto* each : {&pictures.levels, &pictures.others}) {
        for (const TexturePictures::Picture& picture : *each)
            texels += texelsOf(picture);
    }
    return texels <= quickTexels;
}

struct LevelsWorker::State {
    State(When chosen, std::function<void()> wake, LevelWork how)
        : when(chosen)
        , levelWork(std::move(how))
        , worker(
              {when, JobOrder::Queue, levelsFailure, std::move(wake), levelWork.stop},
              [this](const Making::Task& task) { return work(task); },
              [](const Job& job, Error error) {
                  auto levels = std::make_shared<const PreparedLevels>(fail(std::move(error)));
                  auto summary = summarise(job.request, *levels);
                  return Done{job.ticket, std::move(levels), std::move(summary)};
              }) {}

    struct Entry {
        LevelsRequest request;
        Ticket ticket = 0;                            ///< of the work that it waits for; 0: none
        std::shared_ptr<const PreparedLevels> levels; ///< until the renderer has taken them
        std::shared_ptr<const LevelsSummary> summary;
        bool cancelled = false;
        std::uint64_t frame = 0;      ///< in which it was asked for last
        std::uint64_t readyFrame = 0; ///< in which `levels` came
    };
    struct Job {
        Ticket ticket = 0;
        LevelsRequest request;
        /// Measure `made` against this, or free it where there is none; nullptr: make levels.
        std::shared_ptr<const PreparedLevels> from;
        std::vector<TextureLevel> made;
        std::shared_ptr<const LevelsSummary> known; ///< with `made`: what there is to say already, or nullptr
    };
    struct Done {
        Ticket ticket = 0;
        std::shared_ptr<const PreparedLevels> levels; ///< nullptr: only measured
        std::shared_ptr<const LevelsSummary> summary;
    };
    using Making = Worker<Job, Done, Progress>;

    const When when;
    const LevelWork levelWork; ///< of what is made while one waits

    // Of the thread that asks.
    std::deque<Entry> entries;
    std::uint64_t frame = 1;
    Ticket lastTicket = 0;

    Making worker; // last: it ends before the rest does

    Entry* find(const LevelsRequest& request) {
        const auto found = std::ranges::find(entries, request, &Entry::request);
        return found == entries.end() ? nullptr : &*found;
    }
    Entry& entryOf(const LevelsRequest& request);
    void ask(Entry& entry);
    void give(Job job);
    void drop(Ticket ticket);
    std::optional<Done> work(const Making::Task& task) const;
    static Done work(const Job& job, const LevelWork& how);
};

LevelsWorker::State::Entry& LevelsWorker::State::entryOf(const LevelsRequest& request) {
    Entry* found = find(request);
    Entry& entry = found ? *found : entries.emplace_back(Entry{request, 0, {}, {}, false, 0, 0});
    entry.frame = frame;
    return entry;
}

LevelsWorker::State::Done LevelsWorker::State::work(const Job& job, const LevelWork& how) {
    if (job.from)
        return {job.ticket, nullptr,
                job.made.empty() ? nullptr
                                 : measure(*job.from, job.made, job.known ? *job.known : LevelsSummary{})};
    std::vector<Thumbnail> steps;
    LevelWork watched = how;
    watched.step = [&steps](const Image& image, bool topFirst) { steps.push_back(smallOf(image, topFirst)); };
    auto levels = std::make_shared<const PreparedLevels>(make(job.request, watched));
    auto summary = summarise(job.request, *levels, std::move(steps));
    return {job.ticket, std::move(levels), std::move(summary)};
}

std::optional<LevelsWorker::State::Done> LevelsWorker::State::work(const Making::Task& task) const {
    const Job& job = task.job();
    int percent = -1;
    const auto say = [&](float share) {
        if (const int now = static_cast<int>(100 * share); std::exchange(percent, now) != now)
            task.report({job.ticket, nameOf(job.request.settings), share});
    };
    if (!job.from)
        say(0);
    Done done = work(job, {levelWork.cache, say, task.stop(), {}});
    return done.summary ? std::optional(std::move(done)) : std::nullopt;
}

/// Levels are made: now, or on the thread.
void LevelsWorker::State::ask(Entry& entry) {
    if (entry.ticket != 0 || entry.cancelled)
        return;
    Job job{++lastTicket, entry.request, {}, {}, {}};
    if (when == When::WhenReady && !isQuick(entry.request)) {
        entry.ticket = job.ticket;
        return give(std::move(job));
    }
    Done made = work(job, levelWork);
    entry.levels = std::move(made.levels);
    entry.summary = std::move(made.summary);
    entry.readyFrame = frame;
}

void LevelsWorker::State::give(Job job) {
    std::optional<Progress> waiting;
    if (!job.from)
        waiting = Progress{job.ticket, nameOf(job.request.settings), 0};
    worker.ask(std::move(job), std::move(waiting));
}

void LevelsWorker::State::drop(Ticket ticket) {
    const auto isIt = [ticket](const auto& each) { return each.ticket == ticket; };
    worker.drop(isIt);
    worker.discard(isIt);
}

LevelsWorker::LevelsWorker(When when, std::function<void()> wake, LevelWork work)
    : state_(std::make_unique<State>(when, std::move(wake), std::move(work))) {}

LevelsWorker::~LevelsWorker() = default;

std::shared_ptr<const PreparedLevels> LevelsWorker::prepare(const LevelsRequest& request) {
    State::Entry& entry = state_->entryOf(request);
    if (entry.cancelled)
        return std::make_shared<const PreparedLevels>(
            fail(ErrorCode::Cancelled, "making its levels was cancelled"));
    if (!entry.levels)
        state_->ask(entry);
    return std::exchange(entry.levels, nullptr);
}

bool LevelsWorker::isLive() const {
    return state_->when == When::WhenReady;
}

void LevelsWorker::uploaded(const LevelsRequest& request, std::shared_ptr<const PreparedLevels> levels,
                            std::vector<TextureLevel> made) {
    if (!levels || !*levels)
        return;
    const bool later = isLive() && !isQuick(request);
    State::Job job{++state_->lastTicket, request, std::move(levels), std::move(made), {}};
    if (job.made.empty()) { // only to be freed, which the worker does
        if (later)
            state_->give(std::move(job));
        return;
    }
    State::Entry& entry = state_->entryOf(request);
    if (entry.ticket != 0)
        return;
    job.known = entry.summary;
    if (!later) {
        entry.summary = State::work(job, state_->levelWork).summary;
        return;
    }
    entry.ticket = job.ticket;
    state_->give(std::move(job));
}

std::shared_ptr<const LevelsSummary> LevelsWorker::summary(const LevelsRequest& request) {
    State::Entry& entry = state_->entryOf(request);
    if (!entry.summary && !entry.levels)
        state_->ask(entry);
    return entry.summary;
}

std::shared_ptr<const LevelsSummary> LevelsWorker::find(const LevelsRequest& request) const {
    const State::Entry* entry = state_->find(request);
    return entry ? entry->summary : nullptr;
}

bool LevelsWorker::receive() {
    State& state = *state_;
    std::vector<State::Done> done = state.worker.take();
    for (State::Done& each : done) {
        const auto entry = std::ranges::find(state.entries, each.ticket, &State::Entry::ticket);
        if (entry == state.entries.end())
            continue;
        entry->ticket = 0;
        entry->summary = std::move(each.summary);
        if (each.levels) {
            entry->levels = std::move(each.levels);
            entry->readyFrame = state.frame + 1;
        }
    }
    std::erase_if(state.entries, [&](const State::Entry& entry) {
        const bool forsaken = entry.ticket != 0 && !entry.summary && entry.frame != state.frame;
        if (forsaken)
            state.drop(entry.ticket);
        return forsaken;
    });
    for (State::Entry& entry : state.entries) { // not requested any more: they are large
        if (entry.readyFrame < state.frame)
            entry.levels.reset();
    }
    while (state.entries.size() > maxEntries) {
        const auto oldest = std::ranges::min_element(state.entries, {}, &State::Entry::frame);
        if (oldest->ticket != 0)
            state.drop(oldest->ticket);
        state.entries.erase(oldest);
    }
    ++state.frame;
    return !done.empty();
}

std::optional<LevelsWorker::Progress> LevelsWorker::progress() const {
    return state_->worker.progress();
}

void LevelsWorker::cancel(Ticket ticket) {
    state_->drop(ticket);
    const auto entry = std::ranges::find(state_->entries, ticket, &State::Entry::ticket);
    if (entry == state_->entries.end())
        return;
    entry->ticket = 0;
    entry->cancelled = true;
}

void LevelsWorker::retry(const LevelsRequest& request) {
    if (State::Entry* entry = state_->find(request))
        entry->cancelled = false;
}

bool LevelsWorker::isCancelled(const LevelsRequest& request) const {
    const State::Entry* entry = state_->find(request);
    return entry && entry->cancelled;
}

void LevelsWorker::wait() const {
    state_->worker.wait();
}

} // namespace texplorer
