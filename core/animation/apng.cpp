#include "texplorer/animation/apng.h"

#include "texplorer/animation/opaque_frame.h"
#include "texplorer/codec/png/png.h"
#include "texplorer/codec/png/png_chunks.h"

#include <cstring>
#include <libdeflate.h>
#include <new>

namespace texplorer::animation {
namespace {

void append16(Bytes& bytes, std::uint32_t number) {
    bytes.push_back(static_cast<std::byte>(number >> 8U));
    bytes.push_back(static_cast<std::byte>(number));
}

void append32(Bytes& bytes, std::uint32_t number) {
    append16(bytes, number >> 16U);
    append16(bytes, number);
}

void append(Bytes& bytes, ByteView more) {
    bytes.insert(bytes.end(), more.begin(), more.end());
}

/// The part of a picture, as PNG's writer takes it: bottom row first.
Image cut(const OpaqueFrame& frame, const FrameRect& rect) {
    Image image = Image::uninitialised(PixelFormat::Rgb8, rect.width, rect.height);
    for (int y = 0; y < rect.height; ++y) {
        const std::uint32_t* from = frame.row(rect.y + y) + rect.x;
        auto* to = image.at(0, rect.height - 1 - y).data();
        for (int x = 0; x < rect.width; ++x, to += 3) {
            to[0] = static_cast<std::byte>(from[x] >> 16U);
            to[1] = static_cast<std::byte>(from[x] >> 8U);
            to[2] = static_cast<std::byte>(from[x]);
        }
    }
    return image;
}

class ApngEncoder : public Encoder {
public:
    explicit ApngEncoder(const Settings& settings)
        : settings_(settings) {}

    Result<void> add(const Image& picture, int duration) override {
        try {
            return put(opaqueFrame(picture), duration);
        } catch (const std::bad_alloc&) {
            return fail(ErrorCode::TooLarge, "PNG: not enough memory for the animation");
        }
    }

    Result<Bytes> finish() override {
        chunk("IEND", {});
        Bytes counts; // of the chunk acTL, which stands in front of all pictures
        append32(counts, frames_);
        append32(counts, static_cast<std::uint32_t>(settings_.plays));
        Bytes control;
        std::swap(control, file_);
        chunk("acTL", counts);
        std::swap(control, file_);
        std::memcpy(file_.data() + controlAt_, control.data(), control.size());
        return std::move(file_);
    }

private:
    Result<void> put(OpaqueFrame frame, int duration) {
        // A picture that is the same needs a rectangle all the same: the smallest.
        const FrameRect rect = frames_ == 0 ? FrameRect{0, 0, frame.width, frame.height}
                                            : changedRect(last_, frame).value_or(FrameRect{0, 0, 1, 1});
        WriteOptions options;
        if (frames_ == 0)
            options.texts = settings_.texts;
        const Result<Bytes> png = encodePng(cut(frame, rect), options);
        if (!png)
            return tl::unexpected(png.error());
        if (frames_ == 0)
            begin(*png);
        fcTL(rect, duration);
        PngChunks chunks(*png);
        while (const std::optional<PngChunk> each = chunks.next()) {
            if (each->type != "IDAT")
                continue;
            if (frames_ == 0) {
                chunk("IDAT", each->data);
                continue;
            }
            Bytes data;
            data.reserve(4 + each->data.size());
            append32(data, sequence_++);
            append(data, each->data);
            chunk("fdAT", data);
        }
        ++frames_;
        last_ = std::move(frame);
        if (file_.size() > maxAnimationBytes)
            return fail(ErrorCode::TooLarge,
                        Sentence("PNG: with {0} pictures it would be larger than {1} bytes", frames_,
                                 maxAnimationBytes));
        return {};
    }

    /// The signature, IHDR, a place for acTL, and the texts.
    void begin(ByteView png) {
        append(file_, std::as_bytes(std::span(pngSignature)));
        PngChunks chunks(png);
        while (const std::optional<PngChunk> each = chunks.next()) {
            if (each->type == "IDAT" || each->type == "IEND")
                continue;
            chunk(each->type.c_str(), each->data);
            if (each->type == "IHDR") {
                controlAt_ = file_.size();
                file_.resize(file_.size() + 8 + 12);
            }
        }
    }

    void fcTL(const FrameRect& rect, int duration) {
        Bytes data;
        append32(data, sequence_++);
        for (const int number : {rect.width, rect.height, rect.x, rect.y})
            append32(data, static_cast<std::uint32_t>(number));
        append16(data, static_cast<std::uint32_t>(duration));
        append16(data, static_cast<std::uint32_t>(settings_.unitsPerSecond));
        data.push_back(std::byte{0}); // it stays
        data.push_back(std::byte{0}); // and takes the place of what was there
        chunk("fcTL", data);
    }

    void chunk(const char* type, ByteView data) {
        append32(file_, static_cast<std::uint32_t>(data.size()));
        const std::size_t start = file_.size();
        append(file_, viewBytes(type));
        append(file_, data);
        append32(file_, libdeflate_crc32(0, file_.data() + start, file_.size() - start));
    }

    static ByteView viewBytes(const char* type) { return std::as_bytes(std::span(type, 4)); }

    Settings settings_;
    Bytes file_;
    OpaqueFrame last_;
    std::size_t controlAt_ = 0;
    std::uint32_t frames_ = 0;
    std::uint32_t sequence_ = 0;
};

} // namespace

std::unique_ptr<Encoder> apngEncoder(const Settings& settings) {
    return std::make_unique<ApngEncoder>(settings);
}

} // namespace texplorer::animation
