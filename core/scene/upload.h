#pragma once

#include "texplorer/gl/transfer.h"
#include "texplorer/upload/pixel_memory.h"

#include <glm/vec4.hpp>

#include <string_view>

namespace texplorer {

/// What a program's memory holds of an image.
enum class MemoryRows : std::uint32_t { File, Layout };

inline constexpr std::array memoryRowsRows{
    row(MemoryRows::File, "file", N_("As in the file"),
        "The rows of the file: BMP's are blue, green, red, and padded to 4 bytes; TGA's are not padded. Of "
        "other images red, green, blue."),
    row(MemoryRows::Layout, "layout", N_("As below"), "Rows in the format, type and alignment below."),
};

template<>
struct EnumTable<MemoryRows> {
    static constexpr std::span<const EnumRow> rows = memoryRowsRows;
};
static_assert(memoryRowsRows.size() == 2);

/// How an image gets from a program's memory into a texture (OpenGL 2.1, section 3.6): what the program
/// holds, and what it tells glTexImage about it. If both agree, the texture has the image.
struct Upload {
    bool custom = false; ///< off: the call fits the memory, and the other members have no effect
    MemoryRows memory = MemoryRows::File;
    TransferFormat memoryFormat = TransferFormat::Rgba; ///< like the next two: for MemoryRows::Layout
    TransferType memoryType = TransferType::UnsignedByte;
    int memoryAlignment = 1; ///< rows begin at multiples of so many bytes
    TransferFormat format = TransferFormat::Rgba;
    TransferType type = TransferType::UnsignedByte;
    int alignment = 4; ///< of glPixelStorei, like the next four
    int rowLength = 0;
    int skipRows = 0;
    int skipPixels = 0;
    bool swapBytes = false;
    glm::vec4 scale{1}; ///< of glPixelTransferf
    glm::vec4 bias{0};

    bool operator==(const Upload&) const = default;
};

/// The layout of a program's memory, and the bytes at whose multiples rows begin.
struct MemoryLayout {
    PixelLayout pixels{};
    int alignment = 1;

    bool operator==(const MemoryLayout&) const = default;
};

/// `image`: the format of the pixels. `file`: that of the file, "BMP"; empty for a pattern.
[[nodiscard]] MemoryLayout memoryOf(const Upload& upload, PixelFormat image, std::string_view file);

/// The custom call.
[[nodiscard]] UploadCall callOf(const Upload& upload);

/// The call with which rows of `width` pixels are read as they are: with OpenGL's alignment of 4 where that
/// is the same. `isDepth`: for a depth texture, which takes GL_DEPTH_COMPONENT alone.
[[nodiscard]] UploadCall fittingCall(const MemoryLayout& memory, int width, bool isDepth);

/// The same as parameters: a custom upload that changes nothing yet.
[[nodiscard]] Upload fittingUpload(const Upload& upload, const MemoryLayout& memory, int width, bool isDepth);

} // namespace texplorer
