#include "app/render/live_texture.h"

#include "app/view/driver_facts.h"
#include "texplorer/base/sentence_format.h"
#include "texplorer/image/power_of_two.h"

#include <fmt/core.h>

#include <algorithm>
#include <limits>
#include <string>
#include <utility>

namespace texplorer::render {

namespace {

/// Limits the time of a frame with an upload to about ten milliseconds on llvmpipe.
constexpr std::size_t bytesPerFrame = std::size_t{8} << 20;

/// "64", "64 x 32" or "64 x 32 x 8": one extent per axis of the target.
std::string extents(const Surface& surface, Target target) {
    std::string text = std::to_string(widthOf(surface));
    if (target != Target::Texture1D)
        text += fmt::format(" × {}", heightOf(surface));
    if (target == Target::Texture3D)
        text += fmt::format(" × {}", depthOf(surface));
    return text;
}

/// Whether the driver chooses what the levels are stored as.
bool isDriversChoice(const TextureLevels& levels) {
    return isGenericCompressed(levels.internalFormat) && !levels.driverFormat &&
           std::holds_alternative<Image>(*levels.levels.front().surface);
}

/// Why a driver cannot take these levels unchanged; empty: it can.
Sentence lackingFormat(const TextureLevels& levels, const view::Capabilities& capabilities) {
    std::optional<BlockFormat> format = levels.driverFormat;
    if (const auto* blocks = std::get_if<BlockImage>(&*levels.levels.front().surface))
        format = blocks->format;
    if (!format && isFloat(levels.internalFormat) && !capabilities.floatTextures)
        return Sentence("the driver has no {0} ({1}); uploaded with 8 bits, limited to 0 … 1",
                        ProperName{rowOf(levels.internalFormat).name},
                        ProperName{rowOf(levels.internalFormat).since});
    if (!format || (isS3tc(*format) ? capabilities.s3tc : capabilities.rgtc))
        return {};
    const EnumRow& row = rowOf(*format);
    return row.since.starts_with("GL_")
               ? Sentence("the driver has no {0} ({1}); uploaded decompressed", ProperName{row.name},
                          ProperName{row.since})
               : Sentence("the driver has no {0}; uploaded decompressed", ProperName{row.name});
}

} // namespace

void LiveTexture::follow(const LevelsRequest& request, const view::Capabilities* capabilities,
                         LevelsSource* source, std::string_view where) {
    cancelled_ = false;
    if (isDrawn(request.settings.source)) // may change with every frame: at once or never
        source = nullptr;
    giveBack(source); // one frame later: reading takes time, as does the last part of an upload
    if (shown_ == request)
        return next_.reset();
    if (!next_ || next_->request != request) {
        next_.reset();
        std::shared_ptr<const PreparedLevels> levels =
            source ? source->prepare(request)
                   : std::make_shared<const PreparedLevels>(
                         prepareLevels(request.settings, request.pictures, request.target));
        if (!levels)
            return;
        begin(request, std::move(levels), capabilities, where);
        if (!next_)
            return;
    }
    const std::size_t budget =
        source && source->isLive() ? bytesPerFrame : std::numeric_limits<std::size_t>::max();
    if (next_->object.upload(**next_->levels, next_->cursor, budget, where, next_->errors)) {
        finish();
        if (!source || !source->isLive())
            giveBack(source);
    }
}

/// Shows nothing and reports the reason.
void LiveTexture::refuse(const LevelsRequest& request, std::string_view where, const Sentence& sentence) {
    *this = LiveTexture();
    shown_ = request;
    errors_.add(Sentence("{0}: {1}", ProperName{where}, Sentence("{0}; drawn without it", sentence)));
}

void LiveTexture::begin(const LevelsRequest& request, std::shared_ptr<const PreparedLevels> levels,
                        const view::Capabilities* capabilities, std::string_view where) {
    if (!*levels) {
        const Error& error = levels->error();
        if (error.code != ErrorCode::Cancelled)
            return refuse(request, where, describe(error));
        cancelled_ = true;
        cancelledErrors_ = {};
        return cancelledErrors_.add(Sentence("{0}: {1}", ProperName{where},
                                             Sentence("{0}; what was drawn before stays", error.message)));
    }
    GlErrors errors;
    for (const Sentence& note : (*levels)->notes)
        errors.add(Sentence("{0}: {1}", ProperName{where}, note));
    if (capabilities) {
        const Surface& base = (*levels)->levels.front().surface;
        const int limit = view::driverFacts(*capabilities).maxTexels(request.target);
        if (std::max({widthOf(base), heightOf(base), depthOf(base)}) - 2 * (*levels)->border > limit)
            return refuse(request, where,
                          Sentence("{0} texels exceed the driver's {1} for {2}",
                                   ProperName{extents(base, request.target)}, limit,
                                   ProperName{rowOf(request.target).name}));
        const int rim = 2 * (*levels)->border;
        if (!capabilities->nonPowerOfTwo &&
            !arePowersOfTwo(widthOf(base) - rim, std::max(1, heightOf(base) - rim),
                            std::max(1, depthOf(base) - rim)))
            return refuse(
                request, where,
                Sentence(
                    "{0} texels: the driver supports powers of two only (no GL_ARB_texture_non_power_of_two)",
                    ProperName{extents(base, request.target)}));
        if (const Sentence lack = lackingFormat(**levels, *capabilities); !lack.empty()) {
            errors.add(Sentence("{0}: {1}", ProperName{where}, lack));
            TextureLevels pixels = **levels;
            makeBytes(pixels);
            levels = std::make_shared<const PreparedLevels>(std::move(pixels));
        }
    }
    next_.emplace(Next{request, std::move(levels), TextureObject(request.target), {}, std::move(errors)});
}

/// Replaces the shown levels by the next ones.
void LiveTexture::finish() {
    Next next = std::move(*next_);
    next_.reset();
    const TextureLevels& levels = **next.levels;
    lastLevel_ = levels.lastLevel;
    lateFlip_ = levels.lateFlip;
    shape_ = reference::shapeOf(levels, next.request.target);
    isUnclamped_ =
        isFloat(shape_.internalFormat) || std::ranges::any_of(levels.levels, [](const TextureLevel& each) {
            const auto* blocks = std::get_if<BlockImage>(&*each.surface);
            return blocks &&
                   (blocks->format == BlockFormat::Bc4Signed || blocks->format == BlockFormat::Bc5Signed);
        });
    object_ = std::move(next.object);
    stored_ = std::make_shared<const view::StoredTexture>(object_.stored());
    errors_ = std::move(next.errors);
    shown_ = next.request;
    given_.emplace(Given{std::move(next.request), std::move(next.levels)});
}

void LiveTexture::giveBack(LevelsSource* source) {
    if (!given_)
        return;
    Given given = *std::exchange(given_, std::nullopt);
    if (!source)
        return;
    std::vector<TextureLevel> made;
    if ((*given.levels)->driverFormat || isDriversChoice(**given.levels)) {
        if (Result<std::vector<TextureLevel>> read = object_.read())
            made = std::move(*read);
    }
    source->uploaded(given.request, std::move(given.levels), std::move(made));
}

} // namespace texplorer::render
