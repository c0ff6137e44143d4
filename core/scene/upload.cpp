#include "texplorer/scene/upload.h"

#include <algorithm>

namespace texplorer {
namespace {

/// What a loader of a few lines keeps of an image.
PixelLayout layoutOf(PixelFormat image, bool isBlueFirst) {
    switch (image) {
    case PixelFormat::Alpha8:
        return {TransferFormat::Alpha};
    case PixelFormat::Luminance8:
        return {TransferFormat::Luminance};
    case PixelFormat::LuminanceAlpha8:
        return {TransferFormat::LuminanceAlpha};
    case PixelFormat::Rgb8:
        return {isBlueFirst ? TransferFormat::Bgr : TransferFormat::Rgb};
    case PixelFormat::Depth32:
        return {TransferFormat::DepthComponent, TransferType::UnsignedInt};
    case PixelFormat::Rgba8:
    case PixelFormat::RgbaFloat:
        break;
    }
    return {isBlueFirst ? TransferFormat::Bgra : TransferFormat::Rgba};
}

} // namespace

MemoryLayout memoryOf(const Upload& upload, PixelFormat image, std::string_view file) {
    if (upload.custom && upload.memory == MemoryRows::Layout)
        return {{upload.memoryFormat, upload.memoryType}, effectiveAlignment(upload.memoryAlignment)};
    const bool isBmp = file == "BMP";
    return {layoutOf(image, isBmp || file == "TGA"), isBmp ? 4 : 1};
}

UploadCall callOf(const Upload& upload) {
    return {{upload.format, upload.type},
            {upload.alignment, upload.rowLength, upload.skipRows, upload.skipPixels, upload.swapBytes},
            upload.scale,
            upload.bias};
}

UploadCall fittingCall(const MemoryLayout& memory, int width, bool isDepth) {
    UploadCall call{memory.pixels};
    if (rowStride(call, width) != rowStride({memory.pixels, {.alignment = memory.alignment}}, width))
        call.unpacking.alignment = memory.alignment;
    if (isDepth)
        call.layout.format = TransferFormat::DepthComponent;
    return call;
}

Upload fittingUpload(const Upload& upload, const MemoryLayout& memory, int width, bool isDepth) {
    const UploadCall call = fittingCall(memory, width, isDepth);
    Upload fitting{.custom = true, .memory = upload.memory};
    fitting.memoryFormat = upload.memoryFormat;
    fitting.memoryType = upload.memoryType;
    fitting.memoryAlignment = upload.memoryAlignment;
    fitting.format = call.layout.format;
    fitting.type = call.layout.type;
    fitting.alignment = call.unpacking.alignment;
    return fitting;
}

} // namespace texplorer
