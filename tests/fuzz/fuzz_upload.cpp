// Pixels in a program's memory, read as glTexImage would. An input is |format|type|alignment|swapped|row
// length| skipped rows|skipped pixels|width|height|depth|the memory|.

#include "tests/fuzz/broken.h"
#include "texplorer/upload/pixel_memory.h"

#include <algorithm>
#include <span>

using namespace texplorer;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    constexpr std::size_t head = 10;
    if (size < head)
        return 0;
    UploadCall call;
    call.layout = {static_cast<TransferFormat>(transferFormatRows[data[0] % transferFormatRows.size()].value),
                   static_cast<TransferType>(transferTypeRows[data[1] % transferTypeRows.size()].value)};
    call.unpacking = {data[2] % 10, data[4] % 20, data[5] % 4, data[6] % 4, data[3] % 2 == 1};
    if (!checkLayout(call.layout))
        return 0;
    const PixelExtent extent{1 + data[7] % 17, 1 + data[8] % 17, 1 + data[9] % 3};
    const ByteView memory = std::as_bytes(std::span(data, size)).subspan(head);
    const Image image = readPixels(memory, call, extent);
    if (image.width != extent.width || image.height != extent.height || image.depth != extent.depth)
        fuzz::broken("the image has another size than the call");

    Bytes whole(memory.begin(), memory.end()); // with the zeros that count beyond the end
    whole.resize(std::max<std::size_t>(whole.size(), bytesRead(call, extent)), std::byte{0});
    if (readPixels(whole, call, extent) != image)
        fuzz::broken("bytes beyond the end are not 0");
    const ByteRange last = bytesOf(call, extent, extent.width - 1, extent.height - 1, extent.depth - 1);
    if (last.end() != bytesRead(call, extent))
        fuzz::broken("the last pixel is not the end of what is read");
    if (call.unpacking.swapBytes) {
        UploadCall plain = call;
        plain.unpacking.swapBytes = false;
        if (readPixels(withSwappedBytes(whole, call.layout.type), plain, extent) != image)
            fuzz::broken("swapped bytes are another image");
    }

    // An image in memory is read as it was where the type has its bits.
    const UploadCall fitting{{TransferFormat::Rgba, TransferType::UnsignedByte},
                             {.alignment = effectiveAlignment(call.unpacking.alignment)}};
    const Bytes written = writePixels(image, fitting.layout, fitting.unpacking.alignment);
    if (image.format == PixelFormat::Rgba8 && readPixels(written, fitting, extent) != image)
        fuzz::broken("an image is not read as it was written");
    return 0;
}
