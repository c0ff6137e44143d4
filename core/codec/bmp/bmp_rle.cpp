#include "texplorer/codec/bmp/bmp_rle.h"

#include "texplorer/base/byte_reader.h"

#include <algorithm>

namespace texplorer::bmp {

namespace {

class Cursor {
public:
    Cursor(int width, int height, RleRows& rows)
        : height_(height)
        , rows_(rows)
        , line_(static_cast<std::size_t>(width), std::byte{0}) {}

    [[nodiscard]] bool belowTheEnd() const { return y_ < height_; }
    /// Everything is painted or passed.
    [[nodiscard]] bool full() const { return y_ >= height_ || (y_ == height_ - 1 && x_ == line_.size()); }
    [[nodiscard]] int x() const { return static_cast<int>(x_); }
    [[nodiscard]] int y() const { return y_; }

    /// The next `count` pixels of the row, or fewer where it ends before.
    std::span<std::byte> advance(std::size_t count) {
        if (!belowTheEnd())
            return {};
        const std::size_t room = std::min(count, line_.size() - x_);
        const std::span<std::byte> pixels = std::span(line_).subspan(x_, room);
        x_ += room;
        touched_ = touched_ || room > 0;
        return pixels;
    }

    void move(std::size_t right, int rows) {
        if (rows > 0)
            finishRow();
        y_ = std::min(height_, y_ + rows);
        x_ = std::min(line_.size(), x_ + right);
    }

    void nextRow() {
        move(0, 1);
        x_ = 0;
    }

    void finishRow() {
        if (!touched_ || !belowTheEnd())
            return;
        rows_.row(y_, line_);
        std::ranges::fill(line_, std::byte{0});
        touched_ = false;
    }

private:
    int height_;
    RleRows& rows_;
    Bytes line_;
    std::size_t x_ = 0;
    int y_ = 0;
    bool touched_ = false;
};

// The high half of a byte comes first.
void unpackHalves(ByteView packed, std::span<std::byte> to) {
    for (std::size_t i = 0; i < to.size(); ++i)
        to[i] = i % 2 == 0 ? packed[i / 2] >> 4 : packed[i / 2] & std::byte{15};
}

void paintRun(std::byte value, int bitsPerPixel, std::span<std::byte> to) {
    if (bitsPerPixel == 8) {
        std::ranges::fill(to, value);
        return;
    }
    const std::byte halves[2] = {value >> 4, value & std::byte{15}};
    for (std::size_t i = 0; i < to.size(); ++i)
        to[i] = halves[i % 2];
}

} // namespace

RleReport decodeRle(ByteView codes, int bitsPerPixel, int width, int height, RleRows& rows) {
    RleReport report;
    Cursor cursor(width, height, rows);
    ByteReader reader(codes);
    const auto painted = [&](std::size_t asked, std::size_t got) {
        report.painted += got;
        report.clipped += got < asked ? 1 : 0;
    };
    while (codes.size() - reader.position() >= 2) {
        const std::size_t count = reader.u8();
        const std::uint8_t value = reader.u8();
        if (count > 0) {
            ++report.runs;
            const std::span<std::byte> pixels = cursor.advance(count);
            paintRun(std::byte{value}, bitsPerPixel, pixels);
            painted(count, pixels.size());
        } else if (value == 0) {
            cursor.nextRow();
        } else if (value == 1) {
            report.ended = true;
            break;
        } else if (value == 2) {
            ++report.deltas;
            const std::size_t right = reader.u8();
            cursor.move(right, reader.u8());
            if (reader.truncated())
                break;
        } else {
            ++report.literals;
            const std::size_t size = bitsPerPixel == 8 ? value : (std::size_t{value} + 1) / 2;
            const ByteView indices = reader.take(size);
            if (reader.truncated())
                break;
            // The last code of a file may lack its padding.
            reader.skip(std::min(size % 2, codes.size() - reader.position()));
            const std::span<std::byte> pixels = cursor.advance(value);
            if (bitsPerPixel == 8)
                std::ranges::copy(indices.first(pixels.size()), pixels.begin());
            else
                unpackHalves(indices, pixels);
            painted(value, pixels.size());
        }
    }
    cursor.finishRow();
    report.consumed = reader.position();
    report.row = cursor.y();
    report.column = cursor.x();
    // Many writers leave out the last end-of-picture code; nothing is missing then.
    report.ended = report.ended || cursor.full();
    return report;
}

} // namespace texplorer::bmp
