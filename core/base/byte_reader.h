#pragma once

#include "texplorer/base/bytes.h"

#include <concepts>
#include <cstdint>

namespace texplorer {

/// Reads little-endian numbers in sequence. Bytes beyond the end read as 0, and `truncated` is then true:
/// read all fields of a header, then check once.
class ByteReader {
public:
    explicit ByteReader(ByteView bytes)
        : bytes_(bytes) {}

    [[nodiscard]] bool truncated() const { return truncated_; }
    [[nodiscard]] std::size_t position() const { return position_; } ///< never beyond the end

    std::uint8_t u8() { return number<std::uint8_t>(); }
    std::uint16_t u16() { return number<std::uint16_t>(); }
    std::uint32_t u32() { return number<std::uint32_t>(); }
    std::int32_t i32() { return static_cast<std::int32_t>(u32()); }
    void skip(std::size_t count) { take(count); }

    /// Returns the next `count` bytes, or no bytes if there are fewer.
    ByteView take(std::size_t count) {
        if (count > bytes_.size() - position_) {
            truncated_ = true;
            position_ = bytes_.size();
            return {};
        }
        const ByteView taken = bytes_.subspan(position_, count);
        position_ += count;
        return taken;
    }

private:
    template<std::unsigned_integral T>
    T number() {
        const ByteView taken = take(sizeof(T));
        T value = 0;
        for (std::size_t i = 0; i < taken.size(); ++i)
            value = static_cast<T>(value | static_cast<T>(std::to_integer<T>(taken[i]) << (8 * i)));
        return value;
    }

    ByteView bytes_;
    std::size_t position_ = 0;
    bool truncated_ = false;
};

} // namespace texplorer
