#include "app/animation/webp_encoder.h"

#include "texplorer/animation/opaque_frame.h"

#include <algorithm>
#include <cstring>
#include <new>
#include <string>
#include <webp/encode.h>
#include <webp/mux.h>

namespace texplorer::animation {
namespace {

// Without losses libwebp's own 4 is six times as slow as 1 for a file that is a sixth smaller; 0 is hardly
// smaller than PNG.
constexpr int losslessMethod = 1;

struct DeleteEncoder {
    void operator()(WebPAnimEncoder* encoder) const { WebPAnimEncoderDelete(encoder); }
};

/// Freed at the end.
struct Picture {
    Picture() { good = WebPPictureInit(&value) != 0; }
    Picture(const Picture&) = delete;
    Picture& operator=(const Picture&) = delete;
    ~Picture() { WebPPictureFree(&value); }

    WebPPicture value{};
    bool good = false;
};

class WebpEncoder : public Encoder {
public:
    explicit WebpEncoder(const Settings& settings)
        : settings_(settings) {
        WebPAnimEncoderOptions options;
        bool good = WebPAnimEncoderOptionsInit(&options) != 0 && WebPConfigInit(&config_) != 0;
        options.anim_params.loop_count = settings.plays;
        options.anim_params.bgcolor = 0xFF000000U;
        if (settings.quality) {
            config_.quality = *settings.quality;
        } else {
            config_.lossless = 1;
            config_.method = losslessMethod;
            config_.quality = 0; // of a file without losses: the effort
        }
        config_.thread_level = 1;
        encoder_.reset(good ? WebPAnimEncoderNew(settings.width, settings.height, &options) : nullptr);
        if (!encoder_)
            throw std::bad_alloc();
    }

    Result<void> add(const Image& picture, int duration) override {
        try {
            return put(opaqueFrame(picture), duration);
        } catch (const std::bad_alloc&) {
            return fail(ErrorCode::TooLarge, "WebP: not enough memory for the animation");
        }
    }

    Result<Bytes> finish() override {
        if (WebPAnimEncoderAdd(encoder_.get(), nullptr, time_, nullptr) == 0)
            return refused();
        WebPData data;
        WebPDataInit(&data);
        const bool assembled = WebPAnimEncoderAssemble(encoder_.get(), &data) != 0;
        const std::unique_ptr<void, void (*)(void*)> freed(const_cast<std::uint8_t*>(data.bytes), &WebPFree);
        if (!assembled)
            return refused();
        if (data.size > maxAnimationBytes)
            return fail(ErrorCode::TooLarge,
                        Sentence("WebP: it would be larger than {0} bytes", maxAnimationBytes));
        const auto* bytes = reinterpret_cast<const std::byte*>(data.bytes);
        try {
            return Bytes(bytes, bytes + data.size);
        } catch (const std::bad_alloc&) {
            return fail(ErrorCode::TooLarge, "WebP: not enough memory for the animation");
        }
    }

private:
    tl::unexpected<Error> refused() {
        const char* reason = WebPAnimEncoderGetError(encoder_.get());
        const std::string words = reason && *reason != 0 ? reason : N_("libwebp gives no reason");
        return fail(ErrorCode::TooLarge, Sentence("WebP: it can't be written: {0}", words));
    }

    Result<void> put(const OpaqueFrame& frame, int duration) {
        Picture picture;
        picture.value.use_argb = 1;
        picture.value.width = frame.width;
        picture.value.height = frame.height;
        if (!picture.good || WebPPictureAlloc(&picture.value) == 0)
            throw std::bad_alloc();
        for (int y = 0; y < frame.height; ++y)
            std::copy_n(frame.row(y), frame.width,
                        picture.value.argb + static_cast<std::ptrdiff_t>(y) * picture.value.argb_stride);
        if (WebPAnimEncoderAdd(encoder_.get(), &picture.value, time_, &config_) == 0)
            return refused();
        time_ += duration;
        return {};
    }

    Settings settings_;
    WebPConfig config_{};
    std::unique_ptr<WebPAnimEncoder, DeleteEncoder> encoder_;
    int time_ = 0; ///< of the next picture, in milliseconds
};

} // namespace

Result<std::unique_ptr<Encoder>> webpEncoder(const Settings& settings) {
    return std::make_unique<WebpEncoder>(settings);
}

} // namespace texplorer::animation
