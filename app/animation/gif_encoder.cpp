#include "app/animation/gif_encoder.h"

#include "texplorer/animation/dither.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <gif_lib.h>
#include <new>
#include <utility>

namespace texplorer::animation {
namespace {

struct FreeColorMap {
    void operator()(ColorMapObject* map) const { GifFreeMapObject(map); }
};

/// As giflib wants it: a power of two, filled up with black.
std::unique_ptr<ColorMapObject, FreeColorMap> colorMapOf(const IndexedPicture& picture) {
    const std::size_t used = picture.palette.size() + (picture.nothing ? 1 : 0);
    const std::size_t size = std::bit_ceil(std::max<std::size_t>(used, 2));
    std::unique_ptr<ColorMapObject, FreeColorMap> map(GifMakeMapObject(static_cast<int>(size), nullptr));
    if (!map)
        throw std::bad_alloc();
    std::fill_n(map->Colors, size, GifColorType{});
    for (std::size_t i = 0; i < picture.palette.size(); ++i) {
        const std::uint32_t color = picture.palette[i];
        map->Colors[i] = {static_cast<GifByteType>(color >> 16U), static_cast<GifByteType>(color >> 8U),
                          static_cast<GifByteType>(color)};
    }
    return map;
}

class GifEncoder : public Encoder {
public:
    explicit GifEncoder(const Settings& settings)
        : settings_(settings) {
        int error = 0;
        gif_ = EGifOpen(&file_, &GifEncoder::write, &error);
        if (gif_ == nullptr)
            throw std::bad_alloc();
    }
    ~GifEncoder() override {
        if (gif_ != nullptr)
            EGifCloseFile(gif_, nullptr);
    }

    Result<void> add(const Image& picture, int duration) override {
        try {
            return put(opaqueFrame(picture), duration);
        } catch (const std::bad_alloc&) {
            return fail(ErrorCode::TooLarge, "GIF: not enough memory for the animation");
        }
    }

    Result<Bytes> finish() override {
        int error = 0;
        const bool closed = EGifCloseFile(std::exchange(gif_, nullptr), &error) == GIF_OK;
        if (!closed)
            return refused(error);
        return std::move(file_);
    }

private:
    static int write(GifFileType* gif, const GifByteType* bytes, int count) {
        auto& file = *static_cast<Bytes*>(gif->UserData);
        try {
            const auto* from = reinterpret_cast<const std::byte*>(bytes);
            file.insert(file.end(), from, from + count);
        } catch (const std::bad_alloc&) { // which mustn't go through C
            return 0;
        }
        return count;
    }

    static tl::unexpected<texplorer::Error> refused(int error) {
        const char* reason = GifErrorString(error);
        return fail(ErrorCode::TooLarge, Sentence("GIF: it can't be written: {0}",
                                                  reason ? reason : N_("giflib gives no reason")));
    }

    Result<void> put(OpaqueFrame frame, int duration) {
        const bool first = last_.pixels.empty();
        const IndexedPicture picture = indexed(frame, first ? nullptr : &last_);
        const auto map = colorMapOf(picture);
        const bool written = (!first || begin()) && control(picture, duration) &&
                             EGifPutImageDesc(gif_, picture.rect.x, picture.rect.y, picture.rect.width,
                                              picture.rect.height, false, map.get()) == GIF_OK &&
                             putRows(picture);
        if (!written)
            return refused(gif_->Error);
        last_ = std::move(frame);
        if (file_.size() > maxAnimationBytes)
            return fail(ErrorCode::TooLarge,
                        Sentence("GIF: it would be larger than {0} bytes", maxAnimationBytes));
        return {};
    }

    /// The screen without colours of its own, and how often it is all shown.
    bool begin() {
        EGifSetGifVersion(gif_, true);
        constexpr int bitsOfColors = 8;
        if (EGifPutScreenDesc(gif_, settings_.width, settings_.height, bitsOfColors, 0, nullptr) != GIF_OK)
            return false;
        if (settings_.plays == 1)
            return true;
        // Netscape's: how often it is shown again; 0: for ever.
        const int again = settings_.plays == 0 ? 0 : settings_.plays - 1;
        const std::array<GifByteType, 3> loop{1, static_cast<GifByteType>(again & 0xFF),
                                              static_cast<GifByteType>(again >> 8)};
        return EGifPutExtensionLeader(gif_, APPLICATION_EXT_FUNC_CODE) == GIF_OK &&
               EGifPutExtensionBlock(gif_, 11, "NETSCAPE2.0") == GIF_OK &&
               EGifPutExtensionBlock(gif_, static_cast<int>(loop.size()), loop.data()) == GIF_OK &&
               EGifPutExtensionTrailer(gif_) == GIF_OK;
    }

    bool control(const IndexedPicture& picture, int duration) {
        const GraphicsControlBlock block{DISPOSE_DO_NOT, false, duration,
                                         picture.nothing ? int{*picture.nothing} : NO_TRANSPARENT_COLOR};
        std::array<GifByteType, 4> bytes{};
        EGifGCBToExtension(&block, bytes.data());
        return EGifPutExtension(gif_, GRAPHICS_EXT_FUNC_CODE, static_cast<int>(bytes.size()), bytes.data()) ==
               GIF_OK;
    }

    bool putRows(const IndexedPicture& picture) {
        std::vector<GifPixelType> row(static_cast<std::size_t>(picture.rect.width)); // giflib writes to it
        for (int y = 0; y < picture.rect.height; ++y) {
            std::copy_n(picture.row(y), row.size(), row.begin());
            if (EGifPutLine(gif_, row.data(), picture.rect.width) != GIF_OK)
                return false;
        }
        return true;
    }

    Settings settings_;
    Bytes file_;
    GifFileType* gif_ = nullptr;
    OpaqueFrame last_;
};

} // namespace

Result<std::unique_ptr<Encoder>> gifEncoder(const Settings& settings) {
    return std::make_unique<GifEncoder>(settings);
}

} // namespace texplorer::animation
