#include "app/screenshot/output/picture_writer.h"

#include "app/screenshot/output/interrupts.h"
#include "texplorer/files/file_io.h"
#include "texplorer/image/convert.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace texplorer::screenshot {
namespace {

constexpr std::size_t maxPerEncoder = 3; // pictures that wait for one or are in it
constexpr std::size_t maxWaitingBytes = std::size_t{256}
                                        << 20; // of all together; a larger picture waits alone

} // namespace

/// A picture that is being encoded: however that ends, it no longer waits.
class PictureWriter::Accounted {
public:
    Accounted(PictureWriter& writer, std::size_t encoder, std::size_t bytes)
        : writer_(writer)
        , encoder_(encoder)
        , bytes_(bytes) {}
    Accounted(const Accounted&) = delete;
    Accounted& operator=(const Accounted&) = delete;
    ~Accounted() {
        const std::scoped_lock lock(writer_.mutex_);
        --writer_.waiting_[encoder_];
        writer_.waitingBytes_ -= bytes_;
        writer_.freed_.notify_all();
    }

private:
    PictureWriter& writer_;
    std::size_t encoder_;
    std::size_t bytes_;
};

PictureWriter::PictureWriter(unsigned threads)
    : waiting_(std::max(1U, threads)) {
    for (std::size_t i = 0; i < waiting_.size(); ++i)
        encoders_.push_back(makeEncoder(i));
}

PictureWriter::~PictureWriter() = default;

std::unique_ptr<PictureWriter::Encoder> PictureWriter::makeEncoder(std::size_t index) {
    return std::make_unique<Encoder>(
        WorkerSetup{.words = {"not enough memory to encode the picture", "the picture can't be encoded"}},
        [this, index](const Encoder::Task& task) {
            PictureJob& job = *task.job();
            const Accounted accounted(*this, index, job.image.pixels.size());
            encode(job);
            job.image = {}; // before it is said that there is room
            return std::optional<Answer>();
        },
        [this](const std::shared_ptr<PictureJob>& job, Error error) {
            fail({error.code, std::move(error.message), inFile(job->path.string())});
            return Answer{};
        });
}

void PictureWriter::write(PictureJob job) {
    const std::scoped_lock one(asking_);
    std::size_t encoder = 0;
    {
        std::unique_lock lock(mutex_);
        freed_.wait(lock, [&] {
            encoder = static_cast<std::size_t>(std::ranges::min_element(waiting_) - waiting_.begin());
            const bool alone = std::accumulate(waiting_.begin(), waiting_.end(), std::size_t{0}) == 0;
            return alone || (waiting_[encoder] < maxPerEncoder &&
                             waitingBytes_ + job.image.pixels.size() <= maxWaitingBytes);
        });
        if (failure_)
            return;
        ++waiting_[encoder];
        waitingBytes_ += job.image.pixels.size();
    }
    job.firstInFolder = folders_.insert(job.path.parent_path()).second;
    encoders_[encoder]->ask(std::make_shared<PictureJob>(std::move(job)));
}

void PictureWriter::finish() {
    for (const std::unique_ptr<Encoder>& encoder : encoders_)
        encoder->wait();
}

std::size_t PictureWriter::written() const {
    const std::scoped_lock lock(mutex_);
    return written_;
}

std::optional<Error> PictureWriter::failure() const {
    const std::scoped_lock lock(mutex_);
    return failure_;
}

void PictureWriter::fail(const Error& error) {
    const std::scoped_lock lock(mutex_);
    if (!failure_)
        failure_ = error;
}

void PictureWriter::encode(PictureJob& job) {
    if (failure())
        return;
    WriteOptions options;
    if (job.facts)
        options.texts = textsOf(*job.facts);
    const TextureImage picture =
        textureOf(job.opaque ? withoutAlpha(std::move(job.image)) : std::move(job.image), {});
    const Result<Bytes> bytes = job.format->encode(picture, options);
    if (!bytes)
        return fail({bytes.error().code, bytes.error().message, inFile(job.path.string())});
    std::optional<Uninterrupted> placing;
    const Result<void> placed = writeFileAtomically(
        job.path, *bytes, [&placing] { placing.emplace(); },
        job.firstInFolder ? Leftovers::Remove : Leftovers::Keep);
    if (!placed)
        return fail(placed.error());
    const std::scoped_lock lock(mutex_);
    ++written_;
}

} // namespace texplorer::screenshot
