#include "texplorer/image/cube_faces.h"

#include <algorithm>
#include <array>
#include <cassert>

namespace texplorer {

namespace {

/// The place of a face in its layout, in faces from the top left.
struct Place {
    int column;
    int row;
};

constexpr std::array<Place, cubeFaceCount> rowCross{{{2, 1}, {0, 1}, {1, 0}, {1, 2}, {1, 1}, {3, 1}}};
constexpr std::array<Place, cubeFaceCount> columnCross{{{2, 1}, {0, 1}, {1, 0}, {1, 2}, {1, 1}, {1, 3}}};

Place placeOf(CubeLayout layout, int face) {
    switch (layout) {
    case CubeLayout::Same:
        return {0, 0};
    case CubeLayout::RowStrip:
        return {face, 0};
    case CubeLayout::ColumnStrip:
        return {0, face};
    case CubeLayout::RowCross:
        return rowCross[static_cast<std::size_t>(face)];
    case CubeLayout::ColumnCross:
        return columnCross[static_cast<std::size_t>(face)];
    }
    return {0, 0};
}

/// By half a turn: the last pixel comes first.
void turnOver(Image& image) {
    const auto bytes = static_cast<std::size_t>(bytesPerPixel(image.format));
    std::byte* low = image.pixels.data();
    std::byte* high = image.pixels.data() + image.pixels.size();
    for (; high - low >= static_cast<std::ptrdiff_t>(2 * bytes); low += bytes) {
        high -= bytes;
        std::swap_ranges(low, low + bytes, high);
    }
}

} // namespace

CubeLayout cubeLayout(int width, int height) {
    const auto isRatio = [&](int across, int down) {
        return width % across == 0 && height % down == 0 && width / across == height / down;
    };
    if (isRatio(6, 1))
        return CubeLayout::RowStrip;
    if (isRatio(1, 6))
        return CubeLayout::ColumnStrip;
    if (isRatio(4, 3))
        return CubeLayout::RowCross;
    if (isRatio(3, 4))
        return CubeLayout::ColumnCross;
    return CubeLayout::Same;
}

FaceExtents cubeFaceExtents(int width, int height) {
    switch (cubeLayout(width, height)) {
    case CubeLayout::Same:
        return {width, height};
    case CubeLayout::RowStrip:
        return {height, height};
    case CubeLayout::ColumnStrip:
        return {width, width};
    case CubeLayout::RowCross:
        return {width / 4, width / 4};
    case CubeLayout::ColumnCross:
        return {width / 3, width / 3};
    }
    return {width, height};
}

Image cubeFace(const Image& picture, int face) {
    assert(face >= 0 && face < cubeFaceCount);
    if (picture.empty())
        return {};
    const CubeLayout layout = cubeLayout(picture.width, picture.height);
    const auto [width, height] = cubeFaceExtents(picture.width, picture.height);
    const Place place = placeOf(layout, face);
    Image cut = Image::uninitialised(picture.format, width, height);
    for (int y = 0; y < height; ++y)
        std::copy_n(picture.pixels.data() + picture.offset(place.column * width, place.row * height + y, 0),
                    cut.rowBytes(), cut.pixels.data() + cut.offset(0, y, 0));
    if (layout == CubeLayout::ColumnCross && face == cubeFaceCount - 1)
        turnOver(cut);
    return cut;
}

Image cubeCross(std::span<const Image, cubeFaceCount> faces) {
    const Image& first = faces.front();
    if (first.empty())
        return {};
    const int extent = first.width;
    Image cross = Image::uninitialised(first.format, 4 * extent, 3 * extent);
    std::ranges::fill(cross.pixels, std::byte{0});
    for (int face = 0; face < cubeFaceCount; ++face) {
        const Image& from = faces[static_cast<std::size_t>(face)];
        assert(from.width == extent && from.height == extent && from.format == first.format);
        const Place place = placeOf(CubeLayout::RowCross, face);
        for (int y = 0; y < extent; ++y)
            std::copy_n(from.pixels.data() + from.offset(0, y, 0), from.rowBytes(),
                        cross.pixels.data() + cross.offset(place.column * extent, place.row * extent + y, 0));
    }
    return cross;
}

} // namespace texplorer
