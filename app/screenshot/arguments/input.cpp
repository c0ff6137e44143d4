#include "app/screenshot/arguments/input.h"

#include "app/screenshot/output/messages.h"
#include "texplorer/base/sentence_format.h"
#include "texplorer/codec/image_file.h"
#include "texplorer/codec/registry.h"
#include "texplorer/files/descriptor.h"
#include "texplorer/files/file_kind.h"
#include "texplorer/mesh/obj_lines.h"
#include "texplorer/scene/storage/obj_scene.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdint>
#include <fcntl.h>
#include <unistd.h>
#include <utility>

namespace texplorer::screenshot {
namespace {

/// A pipe that has a name, or what a shell makes of <(command). Devices have no end that they promise.
bool isNamedPipe(const std::string& path) {
    struct stat info = {};
    return ::stat(path.c_str(), &info) == 0 && S_ISFIFO(info.st_mode);
}

Result<Bytes> readPipe(const std::string& path, std::size_t maxBytes, const IsWorthReading& isWorthReading) {
    const Descriptor pipe(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NOCTTY)); // waits for who writes
    if (!pipe.valid())
        return fail(ErrorCode::Unreadable, Sentence("can't be opened: {0}", systemText(errno)), inFile(path));
    return readStream(pipe.get(), path, maxBytes, isWorthReading);
}

} // namespace

bool isStandardInput(const std::string& path) {
    constexpr std::array<std::string_view, 4> names{"-", "/dev/stdin", "/dev/fd/0", "/proc/self/fd/0"};
    return std::ranges::find(names, path) != names.end();
}

bool isObjInput(const std::string& path, ByteView file) {
    return isStandardInput(path) ? beginsAsObj(file) : isObjName(path);
}

std::string inputName(const std::string& path) {
    return isStandardInput(path) ? "standard input" : path;
}

Result<void> checkStandardInputOnce(std::span<const std::string> paths) {
    if (std::ranges::count_if(paths, isStandardInput) > 1)
        return fail(ErrorCode::OutOfRange, "can be read only once, but is named twice",
                    inFile("standard input"));
    return {};
}

Result<Bytes> readInput(const std::string& path, std::size_t maxBytes, const IsWorthReading& isWorthReading) {
    Result<Bytes> bytes = isStandardInput(path)
                              ? readStream(STDIN_FILENO, inputName(path), maxBytes, isWorthReading)
                          : isNamedPipe(path) ? readPipe(path, maxBytes, isWorthReading)
                                              : readFile(path, maxBytes);
    if (bytes)
        tell(fmt::format("read {}, {}", inputName(path),
                         Sentence::plural("{0} byte", "{0} bytes", bytes->size())));
    return bytes;
}

Result<Bytes> readImageInput(const std::string& path) {
    if (!isStandardInput(path) && !isNamedPipe(path)) {
        Result<Bytes> start = readFileStart(path, recognisedBytes);
        if (!start || !recogniseImage(*start))
            return start;
    }
    return readInput(path, defaultMaxFileBytes, ImageHead());
}

bool ImageHead::operator()(ByteView start) {
    if (!recogniseImage(start))
        return false;
    const Result<TextureImage> outline = decodeTexture(start, {.pixels = false});
    if (!outline) // what is said of half of it, too, isn't for want of bytes
        return std::exchange(last_, outline.error().message) != outline.error().message;
    constexpr std::uint64_t maxOtherBytes = std::uint64_t{16} << 20; // of what isn't pixels
    constexpr std::uint64_t perTexel = 16;                           // in 16 bits, and twice that
    std::uint64_t texels = 0;
    for (const Surface& each : outline->surfaces)
        texels += static_cast<std::uint64_t>(widthOf(each)) * static_cast<std::uint64_t>(heightOf(each)) *
                  static_cast<std::uint64_t>(depthOf(each));
    return start.size() < maxOtherBytes + perTexel * texels;
}

} // namespace texplorer::screenshot
