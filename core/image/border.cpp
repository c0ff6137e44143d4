#include "texplorer/image/border.h"

#include "texplorer/image/power_of_two.h"
#include "texplorer/image/resample.h"

#include <algorithm>
#include <array>

namespace texplorer {

namespace {

using Extents = std::array<int, 3>;

Extents extentsOf(const Image& image) {
    return {image.width, image.height, image.depth};
}

/// A box of texels.
struct Box {
    Extents first{0, 0, 0};
    Extents size{1, 1, 1};
};

/// Copies `size` texels, from one place to another.
void copyBox(const Image& from, const Extents& source, Image& to, const Extents& target,
             const Extents& size) {
    const std::size_t row =
        static_cast<std::size_t>(size[0]) * static_cast<std::size_t>(bytesPerPixel(from.format));
    for (int z = 0; z < size[2]; ++z) {
        for (int y = 0; y < size[1]; ++y)
            std::copy_n(from.pixels.data() + from.offset(source[0], source[1] + y, source[2] + z), row,
                        to.pixels.data() + to.offset(target[0], target[1] + y, target[2] + z));
    }
}

// An image with its border falls apart into 3, 9 or 27 parts: its inside, its sides and its corners. `part`
// says for each axis whether it is the one before the inside (0), the inside (1) or the one behind it (2).
//
//     (0, 2) | (1, 2)  | (2, 2)
//     -------+---------+-------
//     (0, 1) | inside  | (2, 1)
//     -------+---------+-------
//     (0, 0) | (1, 0)  | (2, 0)
Box partOf(const Extents& whole, int axes, const Extents& part) {
    Box box;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const int extent = whole[axis];
        if (static_cast<int>(axis) >= axes)
            box.size[axis] = extent;
        else {
            box.first[axis] = part[axis] == 0 ? 0 : part[axis] == 1 ? 1 : extent - 1;
            box.size[axis] = part[axis] == 1 ? extent - 2 : 1;
        }
    }
    return box;
}

template<class Visit> ///< visit(part)
void forEachPart(int axes, Visit visit) {
    const int last = axes > 2 ? 2 : 0; // an axis without a border has one part: 0
    for (int z = 0; z <= last; ++z)
        for (int y = 0; y <= (axes > 1 ? 2 : 0); ++y)
            for (int x = 0; x <= 2; ++x)
                visit(Extents{x, y, z});
}

Extents bordered(Extents inside, int axes) {
    for (std::size_t axis = 0; static_cast<int>(axis) < axes; ++axis)
        inside[axis] += 2;
    return inside;
}

Image sized(PixelFormat format, const Extents& extents) {
    return Image::uninitialised(format, extents[0], extents[1], extents[2]);
}

Image cutOut(const Image& image, const Box& box) {
    Image part = sized(image.format, box.size);
    copyBox(image, box.first, part, {0, 0, 0}, box.size);
    return part;
}

} // namespace

bool hasBorderExtents(int width, int height, int depth, int axes) {
    const Extents extents{width, height, depth};
    bool alsoPowers = true;
    for (std::size_t axis = 0; static_cast<int>(axis) < axes; ++axis) {
        if (!isPowerOfTwo(extents[axis] - 2))
            return false;
        alsoPowers = alsoPowers && isPowerOfTwo(extents[axis]);
    }
    return !alsoPowers;
}

Image repeatEdges(const Image& image, int axes) {
    if (image.empty())
        return {};
    const Extents inside = extentsOf(image);
    const Extents extents = bordered(inside, axes);
    Image made = sized(image.format, extents);
    const auto source = [&](std::size_t axis, int at) {
        return static_cast<int>(axis) < axes ? std::clamp(at - 1, 0, inside[axis] - 1) : at;
    };
    const bool wide = axes > 0;
    for (int z = 0; z < extents[2]; ++z) {
        for (int y = 0; y < extents[1]; ++y) {
            const int fromY = source(1, y);
            const int fromZ = source(2, z);
            copyBox(image, {0, fromY, fromZ}, made, {wide ? 1 : 0, y, z}, {inside[0], 1, 1});
            if (wide) {
                copyBox(image, {0, fromY, fromZ}, made, {0, y, z}, {1, 1, 1});
                copyBox(image, {inside[0] - 1, fromY, fromZ}, made, {extents[0] - 1, y, z}, {1, 1, 1});
            }
        }
    }
    return made;
}

Image withoutBorder(const Image& image, int axes) {
    return cutOut(image, partOf(extentsOf(image), axes, {1, 1, 1}));
}

MipChain applyMipPolicyWithBorder(MipPolicy policy, Image base, int axes, const MipOptions& options) {
    if (base.empty())
        return {};
    const auto withEdgesRepeated = [axes](MipChain levels) {
        for (Image& level : levels)
            level = repeatEdges(level, axes);
        return levels;
    };
    if (!hasBorderExtents(base, axes))
        return withEdgesRepeated(applyMipPolicy(policy, std::move(base), options));
    if (policy == MipPolicy::Colored) {
        MipChain levels = withEdgesRepeated(applyMipPolicy(policy, withoutBorder(base, axes), options));
        levels.front() = std::move(base);
        return levels;
    }
    // Each part is a small image with a chain of its own. A part runs out of levels where it has one texel.
    MipChain levels;
    for (const Image& inside : applyMipPolicy(policy, withoutBorder(base, axes), options))
        levels.push_back(sized(inside.format, bordered(extentsOf(inside), axes)));
    forEachPart(axes, [&](const Extents& part) {
        const MipChain chain =
            applyMipPolicy(policy, cutOut(base, partOf(extentsOf(base), axes, part)), options);
        for (std::size_t i = 0; i < levels.size(); ++i) {
            const Image& from = chain[std::min(i, chain.size() - 1)];
            copyBox(from, {0, 0, 0}, levels[i], partOf(extentsOf(levels[i]), axes, part).first,
                    extentsOf(from));
        }
    });
    return levels;
}

} // namespace texplorer
