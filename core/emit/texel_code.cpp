#include "texplorer/emit/texel_code.h"

#include "texplorer/image/convert.h"
#include "texplorer/image/mipmaps.h"
#include "texplorer/s3tc/surface_pixels.h"
#include "texplorer/texture/level_plan.h"
#include "texplorer/texture/target_image.h"

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstring>
#include <limits>
#include <utility>

namespace texplorer::emit {
namespace {

/// The levels of one number, one for each face.
struct Faces {
    int number;
    std::vector<const Surface*> surfaces;
    Bytes memory{}; ///< of all, one after the other
};

/// What OpenGL takes: square faces, and no level whose base would be larger than most drivers' textures are.
bool isAccepted(const TextureLevel& level, int border, Target target) {
    constexpr int max = 16384;
    constexpr int maxLevels = 15;
    const Surface& surface = level.surface;
    const int extent = std::max({widthOf(surface), heightOf(surface), depthOf(surface)}) - 2 * border;
    return level.number < maxLevels && extent <= max >> level.number &&
           (target != Target::CubeMap || widthOf(surface) == heightOf(surface));
}

std::vector<Faces> facesOf(const TextureLevels& levels, Target target) {
    std::vector<Faces> all;
    for (const TextureLevel& level : levels.levels) {
        if (!isAccepted(level, levels.border, target))
            continue;
        auto found = std::ranges::find(all, level.number, &Faces::number);
        if (found == all.end())
            found = all.insert(all.end(), {level.number, {}});
        found->surfaces.push_back(&*level.surface);
        if (level.memory)
            found->memory.insert(found->memory.end(), level.memory->begin(), level.memory->end());
    }
    std::ranges::sort(all, {}, &Faces::number);
    return all;
}

bool isFlat(const Bytes& texels) {
    return texels.size() > 4 && std::memcmp(texels.data(), texels.data() + 4, texels.size() - 4) == 0;
}

/// What halve() of the program makes: averages of four, or of two where there is one row or column.
bool isHalfOf(const Image& half, const Image& whole) {
    if (whole.depth != 1 || (whole.width > 1 && whole.width % 2 != 0) ||
        (whole.height > 1 && whole.height % 2 != 0) || half.width != std::max(1, whole.width / 2) ||
        half.height != std::max(1, whole.height / 2))
        return false;
    const int right = whole.width > 1 ? 1 : 0;
    const int up = whole.height > 1 ? 1 : 0;
    for (int y = 0; y < half.height; ++y) {
        for (int x = 0; x < half.width; ++x) {
            const int left = x << right;
            const int low = y << up;
            const std::array corners{whole.at(left, low), whole.at(left + right, low),
                                     whole.at(left, low + up), whole.at(left + right, low + up)};
            const ByteView found = half.at(x, y);
            for (std::size_t i = 0; i < 4; ++i) {
                int sum = 2;
                for (const ByteView& corner : corners)
                    sum += std::to_integer<int>(corner[i]);
                if (sum / 4 != std::to_integer<int>(found[i]))
                    return false;
            }
        }
    }
    return true;
}

/// Whether some lines of C draw it.
bool isComputed(LevelCode& level, const Texture& texture, const Image& image, Target target) {
    if (texture.source != SourceKind::Pattern)
        return false;
    const bool isBoard = texture.pattern == Pattern::Checker || texture.pattern == Pattern::CheckerRed;
    if ((!isBoard && texture.pattern != Pattern::Gradient) || target == Target::CubeMap ||
        imageForTarget(drawPattern(texture.pattern), target) != image || image.height == 1)
        return false;
    level.source = isBoard ? TexelSource::Checker : TexelSource::Gradient;
    level.color = {255, 255, 255, 255};
    level.square = 8;
    if (texture.pattern == Pattern::CheckerRed) {
        level.color = {255, 0, 0, 255};
        level.square = 16;
    }
    return true;
}

class CodeMaker {
public:
    CodeMaker(const Texture& texture, const TexturePictures& pictures, Target target, FileReader reader)
        : texture_(texture)
        , picture_(*pictures.base)
        , target_(target)
        , reader_(reader) {}

    /// After a stop request not all of it.
    TextureCode make(const TextureLevels& levels, const std::stop_token& stop, bool readsMemory) {
        if (readsMemory && !levels.levels.empty() && levels.levels.front().memory)
            out_.call = levels.call;
        out_.border = levels.border;
        out_.lastLevel = levels.lastLevel;
        out_.lateFlip = levels.lateFlip;
        out_.driverCompresses = levels.driverFormat.has_value();
        for (const Faces& faces : facesOf(levels, target_)) {
            if (stop.stop_requested())
                break;
            out_.faces = static_cast<int>(faces.surfaces.size());
            if (const auto* blocks = std::get_if<BlockImage>(faces.surfaces.front()))
                addBlocks(faces, *blocks);
            else
                addPixels(faces, std::get<Image>(*faces.surfaces.front()));
        }
        if (reader_ == FileReader::Dds && isWhatTheFileHolds(levels))
            out_.reader = reader_;
        return std::move(out_);
    }

private:
    /// Whether readDds() gives the same levels: those that the file has from a level on, whose blocks may be
    /// turned around where that is done by whole blocks or in the only row of them.
    [[nodiscard]] bool isWhatTheFileHolds(const TextureLevels& levels) {
        if (target_ != Target::Texture2D || picture_.faces != 1 || levels.border != 0 ||
            texture_.compression == Compression::Cached || levels.levels.empty() ||
            std::cmp_greater(levels.levels.size(), picture_.levels))
            return false;
        out_.firstLevel = picture_.levels - static_cast<int>(levels.levels.size());
        out_.flipsBlocks = texture_.flip == FlipMode::Blocks;
        for (std::size_t i = 0; i < levels.levels.size(); ++i) {
            const auto* made = std::get_if<BlockImage>(&*levels.levels[i].surface);
            const auto* held =
                std::get_if<BlockImage>(&picture_.surface(0, out_.firstLevel + static_cast<int>(i)));
            if (!made || !held || levels.levels[i].number != static_cast<int>(i) ||
                made->width != held->width || made->height != held->height)
                return false;
            const bool turns = held->height <= 2 || held->height % 4 == 0;
            if (out_.flipsBlocks ? !turns || !picture_.fileTopFirst : made->blocks != held->blocks)
                return false;
        }
        return true;
    }

    /// Whether a file's picture, upright, is what is uploaded.
    [[nodiscard]] bool isThePicture(const Image& base) const {
        return (reader_ == FileReader::Bmp || reader_ == FileReader::Tga) && target_ == Target::Texture2D &&
               out_.border == 0 && asRgba(uprightImage(picture_)) == base;
    }

    static Bytes joined(const Faces& faces) {
        Bytes bytes;
        for (const Surface* surface : faces.surfaces) {
            const auto* image = std::get_if<Image>(surface);
            const auto* blocks = std::get_if<BlockImage>(surface);
            const Bytes& from = image ? image->pixels : blocks->blocks;
            bytes.insert(bytes.end(), from.begin(), from.end());
        }
        return bytes;
    }

    void addBlocks(const Faces& faces, const BlockImage& first) {
        out_.blocks = first.format;
        out_.levels.push_back(
            {faces.number, first.width, first.height, 1, TexelSource::Compressed, {}, 0, joined(faces)});
    }

    void addPixels(const Faces& faces, const Image& first) {
        LevelCode level{faces.number, first.width, first.height, first.depth};
        if (out_.call) {
            level.source = TexelSource::Memory;
            level.bytes = faces.memory;
            out_.levels.push_back(std::move(level));
            return;
        }
        if (first.format == PixelFormat::Depth32) {
            level.source = TexelSource::Depths;
            level.bytes = joined(faces);
            out_.levels.push_back(std::move(level));
            return;
        }
        if (first.format == PixelFormat::RgbaFloat && texture_.upload.custom) { // others are bytes still
            level.source = TexelSource::Floats;
            level.bytes = joined(faces);
            out_.levels.push_back(std::move(level));
            return;
        }
        std::vector<Image> images;
        Bytes texels;
        for (const Surface* surface : faces.surfaces) {
            images.push_back(asRgba(std::get<Image>(*surface)));
            texels.insert(texels.end(), images.back().pixels.begin(), images.back().pixels.end());
        }
        const bool isBase = out_.levels.empty();
        if (!isBase && out_.border == 0 && isHalved(faces.number, images))
            level.source = TexelSource::Halved;
        else if (isBase && isThePicture(images.front())) {
            level.source = TexelSource::Read;
            out_.reader = reader_;
        } else if (isBase && out_.border == 0 && isComputed(level, texture_, images.front(), target_)) {
        } else if (isFlat(texels)) {
            level.source = TexelSource::Flat;
            std::memcpy(level.color.data(), texels.data(), 4);
        } else if (texels.size() <= std::size_t{4} * maxListed)
            level.bytes = std::move(texels);
        else {
            level.source = TexelSource::Packed;
            level.bytes = packed(texels);
        }
        last_ = std::move(images);
        lastNumber_ = faces.number;
        out_.levels.push_back(std::move(level));
    }

    [[nodiscard]] bool isHalved(int number, const std::vector<Image>& images) const {
        std::vector<Image> whole = last_;
        if (number == lastNumber_ + 2) { // one is left out
            for (Image& image : whole) {
                MipChain above = mipLevelsAbove(MipPolicy::Generated, image);
                if (above.empty()) // of one texel there is no half
                    return false;
                image = std::move(above.front());
            }
        } else if (number != lastNumber_ + 1)
            return false;
        for (std::size_t i = 0; i < images.size() && i < whole.size(); ++i) {
            if (!isHalfOf(images[i], whole[i]))
                return false;
        }
        return images.size() == whole.size();
    }

    const Texture& texture_;
    const TextureImage& picture_;
    Target target_;
    FileReader reader_;
    TextureCode out_;
    std::vector<Image> last_;
    int lastNumber_ = -1;
};

/// With the comma after it.
void writeNumber(std::uint32_t value, NumberType type, std::string& text) {
    std::array<char, 32> digits{};
    const auto write = [&](auto... arguments) {
        text.append(digits.data(),
                    std::to_chars(digits.data(), digits.data() + digits.size(), arguments...).ptr);
    };
    text.clear();
    if (type == NumberType::Float) {
        constexpr float largest = std::numeric_limits<float>::max();
        const auto given = std::bit_cast<float>(value);
        write(std::isnan(given) ? 0 : std::clamp(given, -largest, largest));
        text += text.find_first_of(".e") == std::string::npos ? ".0F" : "F";
    } else if (type == NumberType::UnsignedInt) {
        text = "0x";
        write(value, 16);
    } else
        write(value, 10);
    text += ',';
}

} // namespace

namespace {

/// Those that a program can call for; OpenGL may refuse them.
std::vector<SubimageCode> subimageCodes(const Texture& texture, const TexturePictures& pictures,
                                        Target target) {
    std::vector<SubimageCode> codes;
    Texture unlike = texture; // is not what a function of the program computes
    unlike.source = SourceKind::File;
    const LevelPlan plan = planLevels(texture, pictures, target);
    for (std::size_t i = 0; i < texture.subimages.size(); ++i) {
        const auto refused = std::ranges::find(plan.refusedSubimages, i, &RefusedSubimage::index);
        if (plan.levels.empty() || (refused != plan.refusedSubimages.end() && !refused->isCalled))
            continue;
        TextureLevels one;
        one.levels.push_back({texture.subimages[i].level, subimageOf(texture, pictures, target, i)});
        TextureCode code = CodeMaker(unlike, pictures, target, FileReader::None).make(one, {}, false);
        if (!code.levels.empty())
            codes.push_back({i, std::move(code.levels.front())});
    }
    return codes;
}

} // namespace

Result<TextureCode> textureCode(const Texture& asked, const TexturePictures& pictures, Target target,
                                FileReader reader, const LevelWork& work, bool readsMemory) {
    Result<TextureLevels> levels = prepareLevels(asked, pictures, target, work);
    if (!levels)
        return fail(levels.error());
    Texture texture = asked;
    std::vector<SubimageCode> subimages;
    // Where levels are made here as the driver makes them of a changed base, they are those of the change.
    if (!asked.subimages.empty() && (levels->madeByDriver || !isMadeByDriver(asked.mipmaps))) {
        subimages = subimageCodes(asked, pictures, target);
        texture.subimages.clear();
        levels = prepareLevels(texture, pictures, target, work);
        if (!levels)
            return fail(levels.error());
    }
    const reference::SampledTexture shape = reference::shapeOf(*levels, target);
    bool isCalled = levels->madeByDriver;
    if (texture.mipmaps == MipPolicy::Glu && !texture.upload.custom) { // which scales the image itself
        Texture unscaled = texture;
        unscaled.mipmaps = MipPolicy::GenerateMipmap;
        unscaled.npot = NpotPolicy::Keep;
        Result<TextureLevels> given = prepareLevels(unscaled, pictures, target, work);
        if (!given)
            return fail(given.error());
        isCalled = given->madeByDriver && given->border == 0 && !facesOf(*given, target).empty();
        if (isCalled)
            levels = std::move(given);
    }
    if (isCalled)
        std::erase_if(levels->levels, [](const TextureLevel& level) { return level.number > 0; });
    TextureCode code = CodeMaker(texture, pictures, target, reader).make(*levels, work.stop, readsMemory);
    if (work.stop.stop_requested())
        return fail(ErrorCode::Cancelled, "making its levels was cancelled");
    code.shape = shape;
    code.subimages = std::move(subimages);
    if (isCalled)
        code.mipmaps = texture.mipmaps;
    return code;
}

std::vector<LevelGroup> groupsOf(const TextureCode& code) {
    std::vector<LevelGroup> groups;
    const std::span<const LevelCode> levels = code.levels;
    for (std::size_t first = 0; first < levels.size();) {
        std::size_t end = first + 1;
        int missing = -1;
        for (; end < levels.size() && levels[end].source == TexelSource::Halved; ++end) {
            if (levels[end].number != levels[end - 1].number + 1)
                missing = levels[end].number - 1;
        }
        groups.push_back({levels.subspan(first, end - first), missing});
        first = end;
    }
    return groups;
}

FileReader readerOf(ByteView start) {
    const auto at = [&](std::size_t place) {
        return place < start.size() ? std::to_integer<unsigned>(start[place]) : 0U;
    };
    const auto little = [&](std::size_t place, std::size_t count) {
        unsigned value = 0;
        for (std::size_t i = count; i-- > 0;)
            value = value << 8 | at(place + i);
        return value;
    };
    constexpr unsigned infoHeader = 40;
    constexpr unsigned dds = 0x20534444; // "DDS "
    constexpr unsigned dxt = 0x545844;   // "DXT"
    if (at(0) == 'B' && at(1) == 'M' && little(14, 4) >= infoHeader)
        return little(28, 2) == 24 && little(30, 4) == 0 ? FileReader::Bmp : FileReader::None;
    if (little(0, 4) == dds) {
        const bool isKnown = little(84, 3) == dxt && (at(87) == '1' || at(87) == '3' || at(87) == '5');
        return isKnown && start.size() >= 128 ? FileReader::Dds : FileReader::None;
    }
    const unsigned bits = at(16);
    const unsigned alphaBits = at(17) & 0x0F;
    const bool isPlain = at(1) == 0 && at(2) == 2 && (at(17) & 0xD0) == 0; // colours, and rows from the left
    const bool isTga = isPlain && ((bits == 24 && alphaBits == 0) || (bits == 32 && alphaBits == 8));
    return isTga ? FileReader::Tga : FileReader::None;
}

Bytes packed(ByteView texels) {
    using Texel = std::array<std::uint8_t, 4>;
    Bytes out;
    out.reserve(texels.size() / 2);
    const auto put = [&](int byte) { out.push_back(static_cast<std::byte>(byte)); };
    std::array<Texel, 64> seen{};
    Texel before{0, 0, 0, 255};
    int run = 0;
    for (std::size_t at = 0; at < texels.size(); at += 4) {
        Texel texel{};
        std::memcpy(texel.data(), texels.data() + at, 4);
        if (texel == before) {
            if (++run == 62 || at + 4 == texels.size()) {
                put(0xC0 | (run - 1));
                run = 0;
            }
            continue;
        }
        if (run > 0)
            put(0xC0 | (run - 1));
        run = 0;
        const auto place =
            static_cast<std::size_t>(texel[0] * 3 + texel[1] * 5 + texel[2] * 7 + texel[3] * 11) %
            seen.size();
        const auto change = [&](std::size_t i) { return static_cast<std::int8_t>(texel[i] - before[i]); };
        const int red = change(0);
        const int green = change(1);
        const int blue = change(2);
        const auto fits = [](int value, int max) { return value >= -max && value < max; };
        if (seen.at(place) == texel)
            put(static_cast<int>(place));
        else if (texel[3] != before[3]) {
            put(0xFF);
            for (const std::uint8_t each : texel)
                put(each);
        } else if (fits(red, 2) && fits(green, 2) && fits(blue, 2))
            put(0x40 | (red + 2) << 4 | (green + 2) << 2 | (blue + 2));
        else if (fits(green, 32) && fits(red - green, 8) && fits(blue - green, 8)) {
            put(0x80 | (green + 32));
            put((red - green + 8) << 4 | (blue - green + 8));
        } else {
            put(0xFE);
            for (std::size_t i = 0; i < 3; ++i)
                put(texel[i]);
        }
        seen.at(place) = texel;
        before = texel;
    }
    return out;
}

Bytes withoutZerosAtEnd(Bytes bytes) {
    while (bytes.size() > 1 && bytes.back() == std::byte{0})
        bytes.pop_back();
    return bytes;
}

std::string numbersText(ByteView bytes, NumberType type) {
    constexpr std::size_t margin = 4;
    constexpr std::size_t columns = 100;
    std::string text;
    text.reserve(bytes.size() * 5);
    std::size_t column = 0;
    std::string number;
    const std::size_t step = type == NumberType::Byte ? 1 : 4;
    for (std::size_t at = 0; at + step <= bytes.size(); at += step) {
        std::uint32_t value = 0;
        std::memcpy(&value, bytes.data() + at, step);
        writeNumber(value, type, number);
        if (column == 0 || column + 1 + number.size() > columns) {
            if (column != 0)
                text += '\n';
            text.append(margin, ' ');
            column = margin;
        } else {
            text += ' ';
            ++column;
        }
        text += number;
        column += number.size();
    }
    if (!text.empty())
        text += '\n';
    return text;
}

} // namespace texplorer::emit
