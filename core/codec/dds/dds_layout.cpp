#include "texplorer/codec/dds/dds_layout.h"

#include "texplorer/base/sentence.h"
#include "texplorer/image/mipmaps.h"

#include <fmt/core.h>

#include <algorithm>
#include <bit>
#include <limits>

namespace texplorer::dds {
namespace {

tl::unexpected<Error> malformed(const Sentence& message) {
    return fail(ErrorCode::Malformed, Sentence("DDS: {0}", message));
}

Result<void> checkHeaders(ByteView file, const Header& header) {
    if (file.empty())
        return malformed("the file is empty");
    constexpr std::array magic{std::byte{'D'}, std::byte{'D'}, std::byte{'S'}, std::byte{' '}};
    if (file.size() < magic.size() || !std::ranges::equal(file.first(magic.size()), magic))
        return malformed("the file does not begin with \"DDS \"");
    if (file.size() < legacyEnd)
        return malformed(Sentence("the headers need 128 bytes, the file has {0}", file.size()));
    if (header.size != headerSize)
        return malformed(Sentence("a header has 124 bytes, dwSize is {0}", header.size));
    if (file.size() < header.end())
        return malformed(
            Sentence("the headers need 148 bytes with the DX10 one, the file has {0}", file.size()));
    return {};
}

void readElements(const Header& header, Layout& layout, bool everything, Findings& findings) {
    layout.elements = std::max<std::uint32_t>(1, header.arraySize);
    if (header.arraySize == 0)
        findings.push_back({at::arraySize, N_("arraySize is 0; it is read as 1")});
    if (header.arraySize > 1 && !everything)
        findings.push_back(
            {at::arraySize,
             layout.faces > 1
                 ? Sentence("it is an array of {0} cube maps; scenes show the first", header.arraySize)
                 : Sentence("it is an array of {0} textures; scenes show the first", header.arraySize),
             false});
}

/// What kind of texture it is, in the order in which Direct3D's loaders ask: volume before cube map.
Result<void> readKind(const Header& header, Layout& layout, Findings& findings) {
    const bool volumeCap = (header.caps2 & caps2Volume) != 0;
    const bool depthFlag = (header.flags & flagDepth) != 0;
    const auto volume = [&] {
        layout.depth = static_cast<int>(std::max<std::uint32_t>(1, header.depth));
        if (header.depth == 0)
            findings.push_back({at::depth, N_("dwDepth of a volume is 0; it is read as one slice")});
        else if (!depthFlag)
            findings.push_back({at::flags, N_("DDSD_DEPTH is not set although it is a volume")});
    };
    if (header.extended() && header.dimension >= dimension1D && header.dimension <= dimension3D) {
        const bool cube = (header.miscFlag & miscTextureCube) != 0;
        if (cube && header.dimension != dimension2D)
            return malformed("miscFlag means a cube map, but resourceDimension does not");
        if (cube)
            layout.faces = 6;
        if (header.dimension == dimension3D)
            volume();
        if (header.dimension == dimension1D && header.height != 1) {
            findings.push_back(
                {at::height,
                 Sentence("dwHeight of a line is {0} where 1 is expected; it is read as 1", header.height)});
            layout.height = 1;
        }
        return {};
    }
    if (header.extended())
        findings.push_back(
            {at::dimension,
             Sentence("resourceDimension is {0}, which is not a texture; dwCaps2 is used instead",
                      header.dimension)});

    if (volumeCap || (depthFlag && header.depth > 1)) {
        if (!volumeCap)
            findings.push_back(
                {at::caps2,
                 Sentence(
                     "DDSCAPS2_VOLUME is not set although DDSD_DEPTH is, with {0} slices; it is read as a "
                     "volume",
                     header.depth)});
        if ((header.caps2 & caps2CubeMap) != 0)
            findings.push_back(
                {at::caps2, N_("DDSCAPS2_CUBEMAP and DDSCAPS2_VOLUME are both set; it is read as a volume")});
        volume();
        return {};
    }
    if (header.depth > 1)
        findings.push_back(
            {at::depth,
             Sentence("dwDepth is {0} although it is not marked as a volume; it is ignored", header.depth)});
    const std::uint32_t faces = header.caps2 & caps2AllFaces;
    if ((header.caps2 & caps2CubeMap) == 0) {
        if (faces != 0)
            findings.push_back({at::caps2, N_("faces are set although DDSCAPS2_CUBEMAP is not; it is read as "
                                              "one picture")});
        return {};
    }
    if (faces == 0)
        findings.push_back({at::caps2, N_("DDSCAPS2_CUBEMAP is set, but no face; it is read as all six")});
    else if (faces != caps2AllFaces)
        return fail(ErrorCode::Unsupported,
                    Sentence("DDS: cube maps with all six faces are read, this one has {0}: {1}",
                             std::popcount(faces), ProperName{spellBits(faces, caps2Rows)}));
    layout.faces = 6;
    return {};
}

Result<void> checkExtents(const Layout& layout, const Header& header, const DecodeLimits& limits) {
    std::string extents = fmt::format("{} × {}", header.width, header.height);
    if (layout.depth != 1)
        extents += fmt::format(" × {}", header.depth);
    if (header.width == 0 || layout.height == 0)
        return malformed(
            Sentence("a picture has at least 1 × 1 texels, this one says {0}", ProperName{extents}));
    const auto maxExtent = static_cast<std::uint32_t>(std::max(0, limits.maxExtent));
    // Read as unsigned: what became negative is too large as well.
    const auto tooLarge = [&](int extent) { return static_cast<std::uint32_t>(extent) > maxExtent; };
    if (tooLarge(layout.width) || tooLarge(layout.height) || tooLarge(layout.depth))
        return fail(ErrorCode::TooLarge,
                    Sentence("DDS: at most {0} texels along each axis are read, the file has {1}", maxExtent,
                             extents));
    if (layout.faces == 6 && layout.width != layout.height)
        return malformed(Sentence("the faces of a cube map are square, these are {0}", extents));

    // So many that no product of them overflows, for any limits.
    const std::uint64_t maxPixels = std::min<std::uint64_t>(limits.maxPixels, std::uint64_t{1} << 40);
    const std::uint64_t slice =
        static_cast<std::uint64_t>(layout.width) * static_cast<std::uint64_t>(layout.height);
    if (slice > maxPixels / static_cast<std::uint64_t>(layout.depth))
        return fail(ErrorCode::TooLarge, Sentence("DDS: at most {0} texels are read, the file has {1}",
                                                  maxPixels, ProperName{extents}));
    return {};
}

void readLevels(const Header& header, Layout& layout, Findings& findings) {
    const auto full = static_cast<std::uint32_t>(mipLevelCount(layout.width, layout.height, layout.depth));
    const std::uint32_t said = header.mipMapCount;
    const bool flagged = (header.flags & flagMipMapCount) != 0;
    layout.levels = static_cast<int>(std::clamp<std::uint32_t>(said, 1, full));
    if (said == 0 && flagged)
        findings.push_back(
            {at::mipMapCount, N_("dwMipMapCount is 0 although DDSD_MIPMAPCOUNT is set; one level is read")});
    else if (said > full)
        findings.push_back(
            {at::mipMapCount, Sentence("dwMipMapCount is {0}, but the chain ends after {1}; the others are "
                                       "ignored",
                                       said, Sentence::plural("{0} level", "{0} levels", full))});
    else if (said > 1 && !flagged)
        findings.push_back(
            {at::flags,
             Sentence("DDSD_MIPMAPCOUNT is not set although dwMipMapCount is {0}; the count is used", said)});
}

/// Nothing that these say is needed. Files without both are common and are left in peace.
void checkPitch(const Header& header, const Layout& layout, Findings& findings) {
    const std::uint32_t said = header.pitchOrLinearSize;
    const std::uint64_t level = layout.chainBytes(1);
    const std::uint64_t row = layout.format.surfaceBytes(layout.width, 1, 1);
    const bool linear = (header.flags & flagLinearSize) != 0;
    const bool pitch = (header.flags & flagPitch) != 0;
    // Of a volume, some writers give the size of a slice.
    const std::uint64_t slice = level / static_cast<std::uint64_t>(layout.depth);
    if (linear && said != level && said != slice)
        findings.push_back(
            {at::pitchOrLinearSize, Sentence("dwPitchOrLinearSize is {0}, but level 0 has {1}; it is ignored",
                                             said, Sentence::plural("{0} byte", "{0} bytes", level))});
    else if (!linear && pitch && said != row)
        findings.push_back(
            {at::pitchOrLinearSize, Sentence("dwPitchOrLinearSize is {0}, but a row has {1}; it is ignored",
                                             said, Sentence::plural("{0} byte", "{0} bytes", row))});
}

void checkFlags(const Header& header, Findings& findings) {
    constexpr std::uint32_t required = flagCaps | flagHeight | flagWidth | flagPixelFormat;
    if ((header.flags & required) != required)
        findings.push_back({at::flags, Sentence("dwFlags lacks {0}; the fields are used anyway",
                                                ProperName{spellBits(required & ~header.flags, flagRows)})});
}

} // namespace

std::string_view faceName(int face) {
    constexpr std::array<std::string_view, 6> names{"+x", "-x", "+y", "-y", "+z", "-z"};
    return names[static_cast<std::size_t>(face)];
}

Level Layout::at(int face, int level) const {
    const auto extent = [&](int base) { return std::max(1, base >> level); };
    Level found{extent(width), extent(height), extent(depth), 0, 0};
    found.offset = begin + static_cast<std::uint64_t>(face) * chainBytes(levels) + chainBytes(level);
    found.size = format.surfaceBytes(found.width, found.height, found.depth);
    return found;
}

std::uint64_t Layout::arrayEnd() const {
    const std::uint64_t element = end() - begin;
    constexpr std::uint64_t max = std::numeric_limits<std::uint64_t>::max();
    return element > (max - begin) / elements ? max : begin + elements * element;
}

std::uint64_t Layout::chainBytes(int count) const {
    std::uint64_t bytes = 0;
    for (int level = 0; level < count; ++level)
        bytes += format.surfaceBytes(std::max(1, width >> level), std::max(1, height >> level),
                                     std::max(1, depth >> level));
    return bytes;
}

Result<Layout> planLayout(ByteView file, const DecodeLimits& limits, Findings& findings) {
    const Header header = readHeader(file);
    if (const Result<void> checked = checkHeaders(file, header); !checked)
        return fail(checked.error());
    checkFlags(header, findings);
    const Result<Format> format = formatOf(header, findings);
    if (!format)
        return fail(format.error());

    Layout layout;
    layout.format = *format;
    layout.begin = header.end();
    layout.width = static_cast<int>(header.width);
    layout.height = static_cast<int>(header.height);
    if (const Result<void> kind = readKind(header, layout, findings); !kind)
        return fail(kind.error());
    if (header.extended())
        readElements(header, layout, limits.everything, findings);
    if (const Result<void> extents = checkExtents(layout, header, limits); !extents)
        return fail(extents.error());
    if (limits.everything && layout.elements > maxElements)
        return fail(ErrorCode::TooLarge,
                    Sentence("DDS: arrays of at most {0} elements are read, this one has {1}", maxElements,
                             layout.elements));
    readLevels(header, layout, findings);
    checkPitch(header, layout, findings);

    // A count that is too high also moves every face but the first: six faces that fill the file exactly with
    // fewer levels were written with fewer.
    if (layout.faces > 1 && layout.arrayEnd() > file.size())
        for (Layout fewer = layout; --fewer.levels > 0;)
            if (fewer.arrayEnd() == file.size()) {
                findings.push_back(
                    {at::mipMapCount,
                     Sentence(
                         "dwMipMapCount is {0}, but the file holds exactly six faces of {1}",
                         header.mipMapCount,
                         Sentence::plural("{0} level", "{0} levels", static_cast<unsigned>(fewer.levels)))});
                return fewer;
            }
    return layout;
}

Result<int> wholeLevels(const Layout& layout, std::size_t fileSize, Findings& findings) {
    if (layout.elements > 1 && fileSize < layout.arrayEnd()) {
        const Sentence needed = Sentence::plural("{0} byte", "{0} bytes", layout.arrayEnd());
        return malformed(layout.faces > 1 ? Sentence("an array of {0} cube maps needs {1}, the file has {2}",
                                                     layout.elements, needed, fileSize)
                                          : Sentence("an array of {0} textures needs {1}, the file has {2}",
                                                     layout.elements, needed, fileSize));
    }
    if (fileSize >= layout.end()) {
        if (fileSize > layout.arrayEnd())
            findings.push_back({layout.arrayEnd(), Sentence("{0} after the last level: ignored",
                                                            Sentence::plural("{0} byte", "{0} bytes",
                                                                             fileSize - layout.arrayEnd()))});
        return layout.levels;
    }
    const auto isWhole = [&](int face, int level) {
        const Level found = layout.at(face, level);
        return found.offset + found.size <= fileSize;
    };
    for (int face = 0; face < layout.faces; ++face)
        if (!isWhole(face, 0)) {
            const Level base = layout.at(face, 0);
            const Sentence surface =
                layout.faces > 1 ? Sentence("level 0 of face {0}", faceName(face)) : N_("level 0");
            return malformed(Sentence("{0} needs {1} from offset {2}, the file has {3}", surface,
                                      Sentence::plural("{0} byte", "{0} bytes", base.size), base.offset,
                                      fileSize));
        }
    int levels = 1;
    while (isWhole(layout.faces - 1, levels))
        ++levels;
    findings.push_back(
        {at::mipMapCount,
         levels == 1
             ? Sentence("dwMipMapCount is {0}, which needs {1}; the file has {2} and only level 0 is whole",
                        layout.levels, Sentence::plural("{0} byte", "{0} bytes", layout.end()), fileSize)
             : Sentence(
                   "dwMipMapCount is {0}, which needs {1}; the file has {2} and only levels 0 to {3} are whole",
                   layout.levels, Sentence::plural("{0} byte", "{0} bytes", layout.end()), fileSize,
                   levels - 1)});
    return levels;
}

} // namespace texplorer::dds
