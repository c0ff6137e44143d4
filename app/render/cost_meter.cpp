#include "app/render/cost_meter.h"

#include "app/render/state_guard.h"

#include <limits>
#include <new>

namespace texplorer::render {
namespace {

using Clock = std::chrono::steady_clock;

// Long against the steps of the clock and the wait for glFinish, short against a frame of the window.
constexpr double minSample = 0.002; // seconds
constexpr int maxRepeats = 4096;
constexpr std::size_t maxSceneBytes = std::size_t{16} << 20U; // an upload of these takes less than a frame
constexpr std::size_t slownessOfCompression = 16;

/// Different in every block, so that none compresses better than the others.
TextureImage variedImage(int side) {
    Image image = Image::uninitialised(PixelFormat::Rgba8, side, side);
    std::uint32_t state = 1;
    for (std::byte& each : image.pixels) {
        state = state * 1664525U + 1013904223U;
        each = static_cast<std::byte>(state >> 24U);
    }
    return textureOf(std::move(image), {});
}

/// The parameters with which the scene's texture is complete with any levels.
Texture plainTexture(const TextureLevels& levels) {
    Texture plain;
    plain.magFilter = MagFilter::Nearest;
    plain.minFilter = MinFilter::Nearest;
    plain.wrapS = plain.wrapT = plain.wrapR = Wrap::ClampToEdge;
    plain.maxLevel = levels.levels.back().number;
    return plain;
}

std::size_t workOf(const TextureLevels& levels) {
    const bool compresses = levels.driverFormat || isGenericCompressed(levels.internalFormat);
    return reportOn(levels.levels).bytes * (compresses ? slownessOfCompression : 1);
}

/// What the guard leaves to those who draw.
void setUpDrawing() {
    for (const GLenum matrix : std::to_array<GLenum>({GL_TEXTURE, GL_PROJECTION, GL_MODELVIEW})) {
        glMatrixMode(matrix);
        glLoadIdentity();
    }
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
    glTexEnvf(GL_TEXTURE_FILTER_CONTROL, GL_TEXTURE_LOD_BIAS, 0);
}

void drawSquare(glm::vec2 repeats) {
    glBegin(GL_QUADS);
    for (const glm::vec2 corner : {glm::vec2(0, 0), glm::vec2(1, 0), glm::vec2(1, 1), glm::vec2(0, 1)}) {
        glTexCoord2f(corner.x * repeats.x, corner.y * repeats.y);
        glVertex2f(corner.x * 2 - 1, corner.y * 2 - 1);
    }
    glEnd();
}

} // namespace

CostMeter::CostMeter(view::Capabilities capabilities, view::CostSubject subject, std::size_t pairs)
    : capabilities_(std::move(capabilities))
    , subject_(std::move(subject))
    , pairs_(pairs) {}

bool CostMeter::measure(view::TextureCosts& costs, std::chrono::milliseconds time) {
    const Clock::time_point end = Clock::now() + time;
    const StateGuard guard;
    glActiveTexture(GL_TEXTURE0);
    setUpDrawing();
    const Result<void> bound = target_.bind({view::largeSquare, view::largeSquare});
    while (row_ < costs.size()) {
        const view::CostRow& row = view::costRows.at(row_);
        view::CostTimes& result = costs.at(row_);
        Result<void> done = bound;
        if (done)
            done = prepared_ ? advance(row, result.times) : prepare(row);
        if (!done)
            result.lack = describe(done.error());
        if (!done || result.times.b.size() >= pairs_) {
            prepared_.reset();
            ++row_;
        }
        if (Clock::now() >= end)
            break;
    }
    return row_ < costs.size();
}

Result<void> CostMeter::prepare(const view::CostRow& row) {
    if (row.needsS3tc() && !capabilities_.s3tc)
        return fail(ErrorCode::Unsupported, N_("the driver has no S3TC"));
    if (std::max(row.a.anisotropy, row.b.anisotropy) > capabilities_.maxAnisotropy)
        return fail(ErrorCode::Unsupported, Sentence("the driver's anisotropy ends at {0}",
                                                     static_cast<int>(capabilities_.maxAnisotropy)));
    Result<Prepared> a = prepare(row.a, row.ofScene);
    Result<Prepared> b = prepare(row.b, row.ofScene);
    if (!a || !b)
        return fail(a ? b.error() : a.error());
    prepared_ = {*std::move(a), *std::move(b)};
    return {};
}

Result<CostMeter::Prepared> CostMeter::prepare(const view::CostVariant& variant, bool ofScene) try {
    Prepared made{.uploads = variant.uploads};
    Texture texture = view::textureOf(variant);
    if (ofScene) {
        if (!subject_.levels)
            return fail(ErrorCode::NotFound, subject_.lack);
        made.target = subject_.target;
        made.levels = subject_.levels;
    } else {
        made.levels =
            std::make_shared<const PreparedLevels>(prepareLevels(texture, variedImage(variant.side)));
    }
    if (!*made.levels)
        return fail(made.levels->error());
    const TextureLevels& levels = **made.levels;
    if (levels.levels.empty())
        return fail(ErrorCode::NotFound, N_("there is no level"));
    if (ofScene) {
        if (workOf(levels) > maxSceneBytes)
            return fail(ErrorCode::TooLarge, N_("it is too large to be uploaded within a frame"));
        texture = plainTexture(levels);
    }
    errors_ = {};
    made.object = TextureObject(made.target, levels, "", errors_);
    made.object.apply(texture, capabilities_.maxAnisotropy, "", errors_);
    return made;
} catch (const std::bad_alloc&) {
    return fail(ErrorCode::TooLarge, N_("not enough memory for this"));
}

Result<void> CostMeter::advance(const view::CostRow& row, PairedTimes& times) {
    for (Prepared& each : *prepared_) {
        if (each.isTried)
            continue;
        // The first drawing compiles and allocates: it is not measured.
        const double sample = timeOf(row, each) * each.repeats;
        each.isTried = sample >= minSample || each.repeats >= maxRepeats;
        if (!each.isTried)
            each.repeats = std::max(1, each.repeats * 2);
        errors_.check(Sentence(ProperName{row.name}));
        return errors_.sentences().empty() ? Result<void>()
                                           : fail(ErrorCode::Driver, errors_.sentences().front());
    }
    auto& [a, b] = *prepared_;
    const double first = timeOf(row, a);
    times.b.push_back(timeOf(row, b));
    times.a.push_back(first);
    return {};
}

double CostMeter::timeOf(const view::CostRow& row, Prepared& variant) {
    const auto target = static_cast<GLenum>(variant.target);
    glViewport(0, 0, row.pixels, row.pixels);
    glEnable(target);
    glFinish();
    const int repeats = std::max(1, variant.repeats);
    const Clock::time_point start = Clock::now();
    for (int i = 0; i < repeats; ++i) {
        if (variant.uploads) {
            UploadCursor cursor;
            static_cast<void>(variant.object.upload(**variant.levels, cursor,
                                                    std::numeric_limits<std::size_t>::max(), "", errors_));
        } else {
            glBindTexture(target, variant.object.name());
        }
        drawSquare(row.repeats);
    }
    glFinish();
    const std::chrono::duration<double> taken = Clock::now() - start;
    glDisable(target);
    return taken.count() / repeats;
}

} // namespace texplorer::render
