#include "app/screenshot/output/output.h"

#include "app/command_line/standard_streams.h"
#include "app/screenshot/output/interrupts.h"
#include "app/screenshot/output/messages.h"
#include "texplorer/base/sentence_format.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <optional>
#include <set>

namespace texplorer::screenshot {
namespace {

/// What bytes are written into, one after the other, instead of being replaced. Disks are not: nobody means
/// to write a picture over one.
bool isStream(const std::string& path) {
    struct stat info = {};
    return isStandardOutput(path) ||
           (::stat(path.c_str(), &info) == 0 && (S_ISFIFO(info.st_mode) || S_ISCHR(info.st_mode)));
}

/// What would be drawn by whoever gets the bytes of a picture as text.
bool isTerminal(const std::string& path) {
    if (isStandardOutput(path))
        return ::isatty(STDOUT_FILENO) == 1;
    struct stat info = {};
    if (::stat(path.c_str(), &info) != 0 || !S_ISCHR(info.st_mode))
        return false;
    const Descriptor device(::open(path.c_str(), O_WRONLY | O_CLOEXEC | O_NOCTTY | O_NONBLOCK));
    return device.valid() && ::isatty(device.get()) == 1;
}

/// Makes the folder of a file where it is missing, and looks whether the file can be written there.
Result<void> checkPlace(const std::string& path, NewFolders& made) {
    const std::filesystem::path folder = std::filesystem::path(path).parent_path();
    if (!folder.empty() && !made.make(folder))
        return fail(ErrorCode::Unwritable, Sentence("the folder can't be made: {0}", systemText(errno)),
                    inFile(folder.string()));
    return checkFileWritable(path);
}

} // namespace

bool isStandardOutput(const std::string& path) {
    constexpr std::array<std::string_view, 4> names{"-", "/dev/stdout", "/dev/fd/1", "/proc/self/fd/1"};
    return std::ranges::find(names, path) != names.end();
}

Result<Output> Output::open(const std::string& path) {
    Output output(path);
    if (isStandardOutput(path))
        return output;
    if (isStream(path)) {
        output.stream_ = Descriptor(::open(path.c_str(), O_WRONLY | O_CLOEXEC | O_NOCTTY));
        if (!output.stream_.valid())
            return fail(ErrorCode::Unwritable, Sentence("can't be opened: {0}", systemText(errno)),
                        inFile(path));
        return output;
    }
    output.made_ = std::make_unique<NewFolders>();
    if (const Result<void> writable = checkPlace(path, *output.made_); !writable)
        return fail(writable.error());
    return output;
}

Result<void> Output::write(ByteView bytes) const {
    const Result<void> written = put(bytes);
    if (written)
        tell(fmt::format("wrote {}, {}", isStandardOutput(path_) ? "standard output" : path_,
                         Sentence::plural("{0} byte", "{0} bytes", bytes.size())));
    return written;
}

Result<void> Output::put(ByteView bytes) const {
    if (isStandardOutput(path_)) {
        const Printing now;
        return writeStandardOutput(bytes);
    }
    if (stream_.valid()) {
        outputBegins();
        if (!writeFully(stream_.get(), bytes))
            return fail(ErrorCode::Unwritable, Sentence("can't be written: {0}", systemText(errno)),
                        inFile(path_));
        return {};
    }
    std::optional<Uninterrupted> placing;
    return writeFileAtomically(path_, bytes, [&placing] { placing.emplace(); });
}

Result<void> checkPlaces(const std::vector<std::string>& names, NewFolders& made) {
    std::set<std::filesystem::path> folders;
    for (const std::string& name : names) {
        if (!folders.insert(std::filesystem::path(name).parent_path()).second)
            continue;
        if (const Result<void> writable = checkPlace(name, made); !writable)
            return writable;
    }
    return {};
}

Result<void> ImageOutput::write(const TextureImage& texture, const WriteOptions& options) const {
    const Result<Bytes> bytes = format->encode(texture, options);
    return bytes ? output.write(*bytes) : fail(bytes.error().code, bytes.error().message, inFile(path));
}

Result<const CodecRow*> imageFormatOf(const std::string& path, std::string_view streamFormat,
                                      std::string_view only, const char* argument) {
    const CodecRow* format = codecForExtension(path);
    if (format == nullptr && !streamFormat.empty() && isStream(path) &&
        !std::filesystem::path(path).has_extension())
        format = &*std::ranges::find(codecRows(), streamFormat, &CodecRow::name);
    if (format != nullptr && format->encode && (only.empty() || format->name == only))
        return format;
    const std::string names = writtenExtensions(", ", only);
    return fail(ErrorCode::Unsupported,
                only.empty() ? Sentence("expected a name that ends in one of {0}, found \"{1}\"",
                                        ProperName{names}, ProperName{path})
                             : Sentence("expected a name that ends in {0}, found \"{1}\"", ProperName{names},
                                        ProperName{path}),
                atOption(argument));
}

tl::expected<ImageOutput, ExitCode> openImageOutput(const std::string& path, std::string_view streamFormat,
                                                    std::string_view only, const char* argument) {
    const Result<const CodecRow*> format = imageFormatOf(path, streamFormat, only, argument);
    if (!format)
        return tl::unexpected(complain(format.error(), wrongCall));
    if (isTerminal(path))
        return tl::unexpected(complain({ErrorCode::OutOfRange,
                                        N_("is a terminal, which can't show a picture; name a file or "
                                           "redirect it"),
                                        inFile(isStandardOutput(path) ? "standard output" : path)},
                                       wrongCall));
    Result<Output> output = Output::open(path);
    if (!output)
        return tl::unexpected(complain(output.error()));
    return ImageOutput{*std::move(output), *format, path};
}

} // namespace texplorer::screenshot
