#include "texplorer/scene/storage/scene_link.h"

#include "texplorer/scene/params/json.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <iterator>
#include <libdeflate.h>
#include <memory>
#include <optional>

namespace texplorer {
namespace {

constexpr std::string_view scheme = "texplorer:";
constexpr std::string_view version = "1:";
constexpr std::array<std::string_view, 3> pages{"http://", "https://", "file://"};
constexpr int compressionLevel = 12; // of libdeflate: the text is short, and is to stay so
constexpr std::string_view letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-_";

using Compressor = std::unique_ptr<libdeflate_compressor, decltype(&libdeflate_free_compressor)>;
using Decompressor = std::unique_ptr<libdeflate_decompressor, decltype(&libdeflate_free_decompressor)>;

bool isLinkSpace(char letter) {
    return letter == ' ' || letter == '\t' || letter == '\r' || letter == '\n';
}

/// The part of an address after its #; anything else as it is, without white space at its beginning.
std::string_view withoutAddress(std::string_view text) {
    text.remove_prefix(static_cast<std::size_t>(std::ranges::find_if_not(text, isLinkSpace) - text.begin()));
    const bool isAddress = std::ranges::any_of(
        pages, [text](std::string_view beginning) { return text.starts_with(beginning); });
    const std::size_t mark = isAddress ? text.find('#') : std::string_view::npos;
    return mark == std::string_view::npos ? text : text.substr(mark + 1);
}

/// Three bytes are four letters of six bits each:
///   aaaaaabb bbbbcccc ccdddddd
std::string toBase64(std::string_view bytes) {
    std::string text;
    text.reserve((bytes.size() * 4 + 2) / 3);
    std::uint32_t bits = 0;
    unsigned count = 0;
    for (const char each : bytes) {
        bits = bits << 8 | static_cast<unsigned char>(each);
        for (count += 8; count >= 6; count -= 6)
            text += letters[bits >> (count - 6) & 63U];
    }
    if (count > 0)
        text += letters[bits << (6 - count) & 63U];
    return text;
}

/// Nothing where another letter stands among them, or bits are left that no encoder writes.
std::optional<std::string> fromBase64(std::string_view text) {
    std::string bytes;
    bytes.reserve(text.size() * 3 / 4);
    std::uint32_t bits = 0;
    unsigned count = 0;
    for (const char letter : text) {
        const std::size_t value = letters.find(letter);
        if (value == std::string_view::npos)
            return std::nullopt;
        bits = bits << 6 | static_cast<std::uint32_t>(value);
        count += 6;
        if (count >= 8) {
            count -= 8;
            bytes += static_cast<char>(bits >> count & 255U);
        }
    }
    const bool rest = count >= 6 || (bits & ((1U << count) - 1)) != 0;
    return rest ? std::nullopt : std::optional(std::move(bytes));
}

Error damaged() {
    return {ErrorCode::Malformed, N_("the link is damaged or incomplete"), {}};
}

Result<std::string> unpack(std::string_view packed) {
    const Decompressor unpacker(libdeflate_alloc_decompressor(), libdeflate_free_decompressor);
    if (!unpacker)
        return fail(ErrorCode::TooLarge, "not enough memory for the scene of the link");
    std::string text;
    for (std::size_t room = std::size_t{1} << 16;; room = std::min(room * 4, maxSceneBytes)) {
        text.resize(room);
        std::size_t size = 0;
        const libdeflate_result result = libdeflate_zlib_decompress(
            unpacker.get(), packed.data(), packed.size(), text.data(), text.size(), &size);
        if (result == LIBDEFLATE_SUCCESS) {
            text.resize(size);
            return text;
        }
        if (result != LIBDEFLATE_INSUFFICIENT_SPACE)
            return fail(damaged());
        if (room == maxSceneBytes)
            return fail(ErrorCode::TooLarge,
                        Sentence("the scene of the link takes more than {0} bytes", maxSceneBytes));
    }
}

} // namespace

bool isSceneLink(std::string_view text) {
    return withoutAddress(text).starts_with(scheme);
}

Result<std::string> writeSceneLink(const Scene& scene) {
    const std::string json = writeScene(scene);
    const Compressor packer(libdeflate_alloc_compressor(compressionLevel), libdeflate_free_compressor);
    if (!packer)
        return fail(ErrorCode::TooLarge, "not enough memory for the link");
    std::string packed(libdeflate_zlib_compress_bound(packer.get(), json.size()), '\0');
    packed.resize(
        libdeflate_zlib_compress(packer.get(), json.data(), json.size(), packed.data(), packed.size()));
    std::string link = std::string(scheme).append(version).append(toBase64(packed));
    if (json.size() > maxSceneBytes || link.size() > maxLinkBytes)
        return fail(ErrorCode::TooLarge,
                    Sentence("the scene is too large for a link: it has {0} letters, at most {1} are "
                             "allowed; save it as a file",
                             link.size(), maxLinkBytes));
    return link;
}

Result<Scene> parseSceneLink(std::string_view text) {
    if (text.size() > maxLinkBytes)
        return fail(ErrorCode::TooLarge,
                    Sentence("the link has {0} letters, at most {1} are read", text.size(), maxLinkBytes));
    std::string dense;
    std::ranges::copy_if(withoutAddress(text), std::back_inserter(dense),
                         [](char each) { return !isLinkSpace(each); });
    std::string_view rest = dense;
    if (!rest.starts_with(scheme))
        return fail(ErrorCode::Malformed,
                    Sentence("expected a link that begins with \"{0}{1}\"", scheme, version));
    rest.remove_prefix(scheme.size());
    if (!rest.starts_with(version))
        return fail(ErrorCode::Unsupported,
                    Sentence("expected a link that begins with \"{0}{1}\"; a later version of Texplorer may "
                             "have made this one",
                             scheme, version));
    rest.remove_prefix(version.size());
    const std::optional<std::string> packed = fromBase64(rest);
    if (!packed)
        return fail(damaged());
    const Result<std::string> json = unpack(*packed);
    if (!json)
        return fail(json.error());
    Result<Scene> scene = parseScene(*json);
    if (!scene)
        return fail(scene.error().code, Sentence("the link has no scene: {0}", describe(scene.error())));
    return scene;
}

} // namespace texplorer
