// Levels that go through a custom call of glTexImage: what the program holds, and what OpenGL makes of it.

#include "texplorer/base/sentence_format.h"
#include "texplorer/image/border.h"
#include "texplorer/image/transparency.h"
#include "texplorer/texture/level_maker.h"

#include <algorithm>
#include <utility>

namespace texplorer {
namespace {

/// What a call may read. A long row length and a large image could otherwise need any amount of memory.
constexpr std::uint64_t maxReadBytes = std::uint64_t{256} << 20;

Result<void> checkMemory(const PixelLayout& layout) {
    if (checkLayout(layout))
        return {};
    return fail(ErrorCode::Unsupported, Sentence("the memory's type {0} does not hold the components of {1}",
                                                 rowOf(layout.type).name, rowOf(layout.format).name));
}

} // namespace

/// What `pixels` returns: the steps are tried on one texel.
PixelFormat LevelMaker::formatOfPixels() const {
    const auto texelOf = [](PixelFormat format) {
        Image texel = Image::uninitialised(format, 1, 1);
        std::ranges::fill(texel.pixels, std::byte{0});
        return texel;
    };
    const Image* image = std::get_if<Image>(&base());
    Image texel = texelOf(image ? image->format : PixelFormat::Rgba8);
    const Image other = texelOf(PixelFormat::Luminance8);
    for (std::size_t i = 0; i < texture_.preparation.size(); ++i) {
        const ImageStep& step = texture_.preparation[i];
        const bool isThere = holdsPicture(pictures_.other(i));
        Operation operation = operationOf(step, {}, false, isThere ? &other : nullptr);
        operation.extent = {1, 1, 1};
        texel = prepared(std::move(texel), operation);
    }
    return applyTransparency(std::move(texel), texture_.transparency, {}).format;
}

MemoryLayout LevelMaker::memoryOfBase() const {
    return memoryOf(texture_.upload, formatOfPixels(), base_.image->format);
}

Result<void> LevelMaker::checkUpload() const {
    const UploadCall call = callOf(texture_.upload);
    if (Result<void> fits = checkLayout(call.layout); !fits)
        return fits;
    if (Result<void> fits = checkMemory(memoryOfBase().pixels); !fits)
        return fits;
    const bool isDepthCall = call.layout.format == TransferFormat::DepthComponent;
    if (isDepthCall == isDepth(texture_.internalFormat))
        return {};
    return fail(ErrorCode::Unsupported,
                isDepthCall
                    ? Sentence("GL_INVALID_OPERATION: {0} is for depth textures, not for {1}",
                               rowOf(call.layout.format).name, rowOf(texture_.internalFormat).name)
                    : Sentence("GL_INVALID_OPERATION: {0} takes {1}, not {2}",
                               rowOf(texture_.internalFormat).name,
                               rowOf(TransferFormat::DepthComponent).name, rowOf(call.layout.format).name));
}

/// The image as OpenGL reads it, and the memory that it reads.
Result<LevelMaker::Read> LevelMaker::readBack(const Image& image) const {
    const UploadCall call = callOf(texture_.upload);
    const PixelExtent extent{image.width, image.height, image.depth};
    const std::uint64_t needed = bytesRead(call, extent);
    if (needed > maxReadBytes)
        return fail(ErrorCode::TooLarge,
                    Sentence("the call would read {0} bytes; at most {1} are read", needed, maxReadBytes));
    const MemoryLayout layout = memoryOf(texture_.upload, image.format,
                                         base_.image->format); // steps may have added components
    Bytes memory = writePixels(image, layout.pixels, layout.alignment);
    const std::size_t held = memory.size();
    Image read = readPixels(memory, call, extent, keepsFloats());
    if (memory.size() < needed)
        memory.resize(static_cast<std::size_t>(needed), std::byte{0});
    return Read{std::move(read), std::make_shared<const Bytes>(std::move(memory)), held, layout};
}

/// The base, of which OpenGL or GLU makes the other levels after it has read it.
Result<void> LevelMaker::takeMadeOfRead(int face, const MipOptions& options) {
    MipOptions before = options; // GLU scales what it has read
    if (readsFirst_ == ReadsFirst::ForGlu)
        before.npot = NpotPolicy::Keep;
    Result<Read> read = readBack(chainOf(MipPolicy::None, pixels(base_, face), before).front());
    if (!read)
        return fail(read.error());
    if (readsFirst_ == ReadsFirst::ForDriver)
        replaceIn(read->image, 0, face);
    if (readsFirst_ == ReadsFirst::ForDriver) // GLU has all bits of what it reads
        read->image = stored(std::move(read->image));
    MipChain chain = chainOf(texture_.mipmaps, std::move(read->image), options);
    int number = 0;
    for (Image& level : chain)
        out_.levels.push_back({number++, std::move(level), face});
    if (readsFirst_ == ReadsFirst::ForDriver && !hasSubimage(0, face))
        read->moveMemoryTo(out_.levels[out_.levels.size() - chain.size()]);
    return {};
}

/// Each level that a program holds.
Result<void> LevelMaker::readLevels() {
    for (TextureLevel& level : out_.levels) {
        Result<Read> read = readBack(std::get<Image>(*level.surface));
        if (!read)
            return fail(read.error());
        level.surface = std::move(read->image);
        read->moveMemoryTo(level);
        if (isStopped())
            break;
    }
    return {};
}

} // namespace texplorer
