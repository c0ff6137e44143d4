#include "texplorer/upload/pixel_memory.h"

#include "texplorer/image/convert.h"
#include "texplorer/image/depth_pixels.h"
#include "texplorer/image/float_pixels.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>

namespace texplorer {
namespace {

using Components = std::array<double, 4>; ///< in the order of the format

/// So many bytes as a number of the processor.
std::uint32_t numberAt(const std::array<std::byte, 4>& bytes, int count) {
    std::uint32_t number = 0;
    for (int i = 0; i < count; ++i) {
        const int place = std::endian::native == std::endian::little ? i : count - 1 - i;
        number |= std::to_integer<std::uint32_t>(bytes[static_cast<std::size_t>(place)]) << (8 * i);
    }
    return number;
}

double maxOf(int bits) {
    return std::exp2(bits) - 1;
}

/// Table 2.9.
double valueOf(std::uint32_t number, TransferType type) {
    switch (type) {
    case TransferType::Byte:
        return (2.0 * static_cast<std::int8_t>(number) + 1) / maxOf(8);
    case TransferType::Short:
        return (2.0 * static_cast<std::int16_t>(number) + 1) / maxOf(16);
    case TransferType::Int:
        return (2.0 * static_cast<std::int32_t>(number) + 1) / maxOf(32);
    case TransferType::Float: {
        const auto value = std::bit_cast<float>(number);
        return std::isnan(value) ? 0 : value;
    }
    default:
        return number / maxOf(8 * factsOf(type).bytes);
    }
}

std::uint32_t numberOf(double value, TransferType type) {
    const auto rounded = [](double number) { return static_cast<std::int64_t>(std::llround(number)); };
    switch (type) {
    case TransferType::Byte:
    case TransferType::Short:
    case TransferType::Int: {
        const int bits = 8 * factsOf(type).bytes;
        return static_cast<std::uint32_t>(
            std::min(rounded((value * maxOf(bits) - 1) / 2), rounded(maxOf(bits - 1))));
    }
    case TransferType::Float:
        return std::bit_cast<std::uint32_t>(static_cast<float>(value));
    default:
        return static_cast<std::uint32_t>(rounded(value * maxOf(8 * factsOf(type).bytes)));
    }
}

/// Where the field of a component begins, in bits from the lowest one, and how many it has.
struct Field {
    int shift;
    int bits;
};
Field fieldOf(const TransferTypeFacts& facts, int component) {
    const int fields = facts.fields();
    const int place = facts.isReversed ? fields - 1 - component : component; // from the highest field
    int shift = 0;
    for (int i = place + 1; i < fields; ++i)
        shift += facts.bits[static_cast<std::size_t>(i)];
    return {shift, facts.bits[static_cast<std::size_t>(place)]};
}

/// The numbers of a pixel; bytes that aren't there are 0.
class Reader {
public:
    Reader(ByteView memory, const UploadCall& call)
        : memory_(memory)
        , type_(call.layout.type)
        , facts_(factsOf(type_))
        , count_(componentsOf(call.layout.format).size())
        , swaps_(call.unpacking.swapBytes) {}

    [[nodiscard]] Components at(std::size_t first) const {
        Components components{};
        if (facts_.isPacked()) {
            const std::uint32_t number = number32(first);
            for (std::size_t i = 0; i < count_; ++i) {
                const Field field = fieldOf(facts_, static_cast<int>(i));
                components[i] = ((number >> field.shift) & ((1U << field.bits) - 1)) / maxOf(field.bits);
            }
            return components;
        }
        for (std::size_t i = 0; i < count_; ++i)
            components[i] = valueOf(number32(first + i * static_cast<std::size_t>(facts_.bytes)), type_);
        return components;
    }

private:
    [[nodiscard]] std::uint32_t number32(std::size_t first) const {
        std::array<std::byte, 4> bytes{};
        const auto size = static_cast<std::size_t>(facts_.bytes);
        if (first < memory_.size())
            std::memcpy(bytes.data(), memory_.data() + first, std::min(size, memory_.size() - first));
        if (swaps_)
            std::reverse(bytes.begin(), bytes.begin() + facts_.bytes);
        return numberAt(bytes, facts_.bytes);
    }

    ByteView memory_;
    TransferType type_;
    const TransferTypeFacts& facts_;
    std::size_t count_;
    bool swaps_;
};

/// Red, green, blue and alpha: what the format leaves out is 0, alpha 1 (section 3.6.4, conversion to RGB).
glm::dvec4 colorOf(const Components& components, std::string_view names) {
    glm::dvec4 color(0, 0, 0, 1);
    for (std::size_t i = 0; i < names.size(); ++i) {
        const double value = components[i];
        switch (names[i]) {
        case 'g':
            color.g = value;
            break;
        case 'b':
            color.b = value;
            break;
        case 'a':
            color.a = value;
            break;
        case 'l':
            color.r = color.g = color.b = value;
            break;
        default: // red, or a depth
            color.r = value;
            break;
        }
    }
    return color;
}

double componentOf(const glm::dvec4& color, char name) {
    switch (name) {
    case 'g':
        return color.g;
    case 'b':
        return color.b;
    case 'a':
        return color.a;
    case 'l':
        return std::round((299 * color.r + 587 * color.g + 114 * color.b) * 255 / 1000) / 255;
    default:
        return color.r;
    }
}

void writeNumber(Bytes& memory, std::size_t first, std::uint32_t number, int count) {
    for (int i = 0; i < count; ++i) {
        const int place = std::endian::native == std::endian::little ? i : count - 1 - i;
        memory[first + static_cast<std::size_t>(place)] = static_cast<std::byte>(number >> (8 * i));
    }
}

void writePixel(Bytes& memory, std::size_t first, const glm::dvec4& color, const PixelLayout& layout) {
    const std::string_view names = componentsOf(layout.format);
    const TransferTypeFacts& facts = factsOf(layout.type);
    std::uint32_t packed = 0;
    for (std::size_t i = 0; i < names.size(); ++i) {
        const double value = componentOf(color, names[i]);
        if (!facts.isPacked()) {
            writeNumber(memory, first + i * static_cast<std::size_t>(facts.bytes),
                        numberOf(value, layout.type), facts.bytes);
            continue;
        }
        const Field field = fieldOf(facts, static_cast<int>(i));
        packed |= static_cast<std::uint32_t>(std::llround(value * maxOf(field.bits))) << field.shift;
    }
    if (facts.isPacked())
        writeNumber(memory, first, packed, facts.bytes);
}

template<class Visit>
void eachPixel(const PixelExtent& extent, Visit visit) {
    for (int z = 0; z < extent.depth; ++z) {
        for (int y = 0; y < extent.height; ++y) {
            for (int x = 0; x < extent.width; ++x)
                visit(x, y, z);
        }
    }
}

} // namespace

int effectiveAlignment(int alignment) {
    return alignment == 1 || alignment == 2 || alignment == 8 ? alignment : 4;
}

Result<void> checkLayout(const PixelLayout& layout) {
    const TransferTypeFacts& facts = factsOf(layout.type);
    // Three components only as GL_RGB, not as GL_BGR (table 3.5).
    const bool fits = !facts.isPacked() || (facts.fields() == 3 ? layout.format == TransferFormat::Rgb
                                                                : layout.format == TransferFormat::Rgba ||
                                                                      layout.format == TransferFormat::Bgra);
    if (fits)
        return {};
    return fail(ErrorCode::Unsupported,
                facts.fields() == 3
                    ? Sentence("GL_INVALID_OPERATION: {0} takes {1}, not {2}", rowOf(layout.type).name,
                               rowOf(TransferFormat::Rgb).name, rowOf(layout.format).name)
                    : Sentence("GL_INVALID_OPERATION: {0} takes {1} or {2}, not {3}", rowOf(layout.type).name,
                               rowOf(TransferFormat::Rgba).name, rowOf(TransferFormat::Bgra).name,
                               rowOf(layout.format).name));
}

int bytesPerPixel(const PixelLayout& layout) {
    const TransferTypeFacts& facts = factsOf(layout.type);
    return facts.isPacked() ? facts.bytes
                            : facts.bytes * static_cast<int>(componentsOf(layout.format).size());
}

std::size_t rowStride(const UploadCall& call, int width) {
    const int pixels = call.unpacking.rowLength > 0 ? call.unpacking.rowLength : width;
    const std::size_t bytes =
        static_cast<std::size_t>(pixels) * static_cast<std::size_t>(bytesPerPixel(call.layout));
    const auto element = static_cast<std::size_t>(factsOf(call.layout.type).bytes);
    const auto alignment = static_cast<std::size_t>(effectiveAlignment(call.unpacking.alignment));
    return element >= alignment ? bytes : (bytes + alignment - 1) / alignment * alignment;
}

ByteRange bytesOf(const UploadCall& call, const PixelExtent& extent, int x, int y, int z) {
    const auto size = static_cast<std::size_t>(bytesPerPixel(call.layout));
    const std::size_t stride = rowStride(call, extent.width);
    const std::size_t row = static_cast<std::size_t>(z) * static_cast<std::size_t>(extent.height) +
                            static_cast<std::size_t>(y) + static_cast<std::size_t>(call.unpacking.skipRows);
    return {row * stride +
                (static_cast<std::size_t>(call.unpacking.skipPixels) + static_cast<std::size_t>(x)) * size,
            size};
}

std::uint64_t bytesRead(const UploadCall& call, const PixelExtent& extent) {
    if (extent.width <= 0 || extent.height <= 0 || extent.depth <= 0)
        return 0;
    return bytesOf(call, extent, extent.width - 1, extent.height - 1, extent.depth - 1).end();
}

Image readPixels(ByteView memory, const UploadCall& call, const PixelExtent& extent, bool asFloats) {
    const std::string_view names = componentsOf(call.layout.format);
    const bool isDepth = call.layout.format == TransferFormat::DepthComponent;
    Image image = Image::uninitialised(isDepth    ? PixelFormat::Depth32
                                       : asFloats ? PixelFormat::RgbaFloat
                                                  : PixelFormat::Rgba8,
                                       extent.width, extent.height, extent.depth);
    const Reader reader(memory, call);
    eachPixel(extent, [&](int x, int y, int z) {
        const ByteRange bytes = bytesOf(call, extent, x, y, z);
        const glm::dvec4 color = colorOf(reader.at(bytes.first), names);
        const auto pixel = image.at(x, y, z);
        if (isDepth) {
            const auto depth =
                static_cast<std::uint32_t>(std::llround(std::clamp(color.r, 0.0, 1.0) * maxOf(32)));
            storeDepth(depth, pixel.data());
            return;
        }
        const glm::dvec4 value = color * glm::dvec4(call.scale) + glm::dvec4(call.bias);
        if (asFloats) {
            const glm::vec4 number(value);
            storeFloats({number.r, number.g, number.b, number.a}, pixel.data());
            return;
        }
        for (int i = 0; i < 4; ++i)
            pixel[static_cast<std::size_t>(i)] =
                static_cast<std::byte>(std::lround(std::clamp(value[i], 0.0, 1.0) * 255));
    });
    return image;
}

Bytes withSwappedBytes(ByteView memory, TransferType type) {
    Bytes swapped(memory.begin(), memory.end());
    const auto size = static_cast<std::ptrdiff_t>(factsOf(type).bytes);
    for (auto number = swapped.begin(); swapped.end() - number >= size; number += size)
        std::reverse(number, number + size);
    return swapped;
}

Bytes writePixels(const Image& image, const PixelLayout& layout, int alignment) {
    const UploadCall call{layout, {.alignment = alignment}};
    const PixelExtent extent{image.width, image.height, image.depth};
    const std::size_t rows = static_cast<std::size_t>(image.height) * static_cast<std::size_t>(image.depth);
    Bytes memory(rowStride(call, image.width) * rows, std::byte{0}); // with what follows the last row
    eachPixel(extent, [&](int x, int y, int z) {
        const std::array<std::uint8_t, 4> bytes = rgbaOf(image.format, image.at(x, y, z).data());
        const glm::dvec4 color(bytes[0] / 255.0, bytes[1] / 255.0, bytes[2] / 255.0, bytes[3] / 255.0);
        writePixel(memory, bytesOf(call, extent, x, y, z).first, color, layout);
    });
    return memory;
}

} // namespace texplorer
