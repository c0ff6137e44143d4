#include "app/screenshot/output/output.h"

#include "app/command_line/standard_streams.h"
#include "app/screenshot/output/interrupts.h"
#include "app/screenshot/output/messages.h"
#include "core/base/count.h"
#include "core/base/printable.h"
#include "core/scene/params/param_text.h"

#include <fmt/core.h>

#include <algorithm>
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

bool isFile(const std::string& path) {
    std::error_code ignored;
    return std::filesystem::is_regular_file(path, ignored);
}

/// Under whatever names.
bool areTheSame(const std::string& file, const std::string& other) {
    std::error_code ignored;
    return isFile(file) && std::filesystem::equivalent(file, other, ignored);
}

} // namespace

bool isStandardOutput(const std::string& path) {
    return path == "-" || path == "/dev/stdout";
}

Result<void> checkNotRead(const char* option, std::span<const std::string> outputs,
                          const std::vector<std::string>& inputs) {
    for (const std::string& output : outputs) {
        if (!isFile(output))
            continue;
        const auto read =
            std::ranges::find_if(inputs, [&](const std::string& input) { return areTheSame(output, input); });
        if (read != inputs.end())
            return fail(ErrorCode::OutOfRange,
                        fmt::format("expected another file than {}, which is read", inQuotes(*read)), option);
    }
    return {};
}

Result<void> checkOutputsApart(const std::vector<NamedOutput>& outputs,
                               const std::vector<std::string>& inputs) {
    for (std::size_t i = 0; i < outputs.size(); ++i) {
        if (const Result<void> apart = checkNotRead(outputs[i].option, {&outputs[i].path, 1}, inputs); !apart)
            return apart;
        for (std::size_t k = 0; k < i; ++k) {
            const std::string& other = outputs[k].path;
            if (isStandardOutput(outputs[i].path) && isStandardOutput(other))
                return fail(ErrorCode::OutOfRange, "expected one text on standard output, found two",
                            fmt::format("{} and {}", outputs[k].option, outputs[i].option));
            const std::filesystem::path own = outputs[i].path;
            if (!other.empty() && (areTheSame(outputs[i].path, other) ||
                                   own.lexically_normal() == std::filesystem::path(other).lexically_normal()))
                return fail(ErrorCode::OutOfRange,
                            fmt::format("expected another file than that of {}", outputs[k].option),
                            outputs[i].option);
        }
    }
    return {};
}

Result<Output> Output::open(const std::string& path) {
    Output output(path);
    if (isStandardOutput(path))
        return output;
    if (isStream(path)) {
        output.stream_ = Descriptor(::open(path.c_str(), O_WRONLY | O_CLOEXEC | O_NOCTTY));
        if (!output.stream_.valid())
            return fail(ErrorCode::Unwritable, "can't be opened: " + systemText(errno), path);
        return output;
    }
    if (const Result<void> writable = checkPlace(path); !writable)
        return fail(writable.error());
    return output;
}

Result<void> checkPlace(const std::string& path) {
    const std::filesystem::path folder = std::filesystem::path(path).parent_path();
    std::error_code error;
    if (!folder.empty() && !std::filesystem::exists(std::filesystem::symlink_status(folder, error)))
        return fail(ErrorCode::Unwritable,
                    fmt::format("can't be written: the folder {} isn't there", folder.string()), path);
    return checkFileWritable(path);
}

Result<void> Output::write(ByteView bytes) const {
    const Result<void> written = put(bytes);
    if (written)
        tell(fmt::format("wrote {}, {}", isStandardOutput(path_) ? "standard output" : path_,
                         countOf(bytes.size(), "byte")));
    return written;
}

Result<void> Output::put(ByteView bytes) const {
    if (isStandardOutput(path_)) {
        outputBegins();
        return writeStandardOutput(bytes);
    }
    if (stream_.valid()) {
        outputBegins();
        if (!writeFully(stream_.get(), bytes))
            return fail(ErrorCode::Unwritable, "can't be written: " + systemText(errno), path_);
        return {};
    }
    std::optional<Uninterrupted> placing;
    return writeFileAtomically(path_, bytes, [&placing] { placing.emplace(); });
}

Result<void> checkPlaces(const std::vector<std::string>& names, NewFolders* made) {
    std::set<std::filesystem::path> folders;
    for (const std::string& name : names) {
        const std::filesystem::path folder = std::filesystem::path(name).parent_path();
        if (!folders.insert(folder).second)
            continue;
        if (made != nullptr && !folder.empty() && !made->make(folder))
            return fail(ErrorCode::Unwritable, "can't make the folder: " + systemText(errno),
                        folder.string());
        if (const Result<void> writable = checkPlace(name); !writable)
            return fail(writable.error());
    }
    return {};
}

Result<void> ImageOutput::write(const TextureImage& texture, const WriteOptions& options) const {
    const Result<Bytes> bytes = format->encode(texture, options);
    return bytes ? output.write(*bytes) : fail(bytes.error().code, bytes.error().message, path);
}

Result<const CodecRow*> imageFormatOf(const std::string& path, std::string_view streamFormat,
                                      std::string_view only) {
    const CodecRow* format = codecForExtension(path);
    if (format == nullptr && !streamFormat.empty() && isStream(path) &&
        !std::filesystem::path(path).has_extension())
        format = &*std::ranges::find(codecRows(), streamFormat, &CodecRow::name);
    if (format != nullptr && format->encode && (only.empty() || format->name == only))
        return format;
    return fail(ErrorCode::Unsupported,
                fmt::format("expected a name that ends in {}{}, found \"{}\"", only.empty() ? "one of " : "",
                            writtenExtensions(", ", only), path));
}

tl::expected<ImageOutput, ExitCode> openImageOutput(const std::string& path, std::string_view streamFormat,
                                                    std::string_view only) {
    const Result<const CodecRow*> format = imageFormatOf(path, streamFormat, only);
    if (!format)
        return tl::unexpected(complain(format.error(), wrongCall));
    if (isTerminal(path))
        return tl::unexpected(complain({ErrorCode::OutOfRange,
                                        "is a terminal, which a picture would only disturb; name a file, or "
                                        "redirect it",
                                        isStandardOutput(path) ? "standard output" : path},
                                       wrongCall));
    Result<Output> output = Output::open(path);
    if (!output)
        return tl::unexpected(complain(output.error()));
    return ImageOutput{*std::move(output), *format, path};
}

Result<void> print(std::string_view text) {
    outputBegins();
    return writeStandardOutput(viewBytes(printable(text, LineBreaks::Keep)));
}

} // namespace texplorer::screenshot
