#include "app/screenshot/arguments/image_files.h"

#include "app/command_line/choice_argument.h"
#include "app/screenshot/arguments/input.h"
#include "app/screenshot/arguments/option_use.h"
#include "app/screenshot/arguments/outputs_apart.h"
#include "app/screenshot/output/interrupts.h"
#include "app/screenshot/output/json_text.h"
#include "app/screenshot/output/messages.h"
#include "app/screenshot/output/output.h"
#include "texplorer/base/sentence_format.h"
#include "texplorer/codec/image_file.h"
#include "texplorer/codec/losses.h"
#include "texplorer/files/file_io.h"
#include "texplorer/image/mipmaps.h"
#include "texplorer/text/printable.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace texplorer::screenshot {
namespace {

using Json = nlohmann::ordered_json;

std::string smallLetters(std::string_view text) {
    std::string small(text);
    std::ranges::transform(small, small.begin(), [](char c) {
        return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    });
    return small;
}

/// "bmp, dds, png, tga"
std::vector<std::string> writtenFormats() {
    std::vector<std::string> names;
    for (const CodecRow& row : codecRows())
        if (row.encode)
            names.push_back(smallLetters(row.name));
    return names;
}

std::string formatNames() {
    return fmt::format("{}", fmt::join(writtenFormats(), ", "));
}

Result<const CodecRow*> formatNamed(const std::string& name) {
    for (const CodecRow& row : codecRows())
        if (row.encode && isSameName(row.name, name))
            return &row;
    return refuseChoice(writtenFormats(), name, "--to");
}

const CodecRow& formatOfName(std::string_view name) {
    return *std::ranges::find(codecRows(), name, &CodecRow::name);
}

/// The format of what is written in that of its input, which may be one that isn't written.
constexpr std::string_view formatInItsPlace = "PNG";
const CodecRow& writtenAs(const CodecRow* its) {
    return its != nullptr && its->encode ? *its : formatOfName(formatInItsPlace);
}

/// By its content; by its name where it can't be looked at twice, or is no image.
const CodecRow* formatOfFile(const std::string& path) {
    std::error_code ignored;
    const Result<Bytes> start =
        std::filesystem::is_regular_file(path, ignored) ? readFileStart(path, recognisedBytes) : Bytes();
    const CodecRow* format = start ? recogniseImage(*start) : nullptr;
    return format != nullptr ? format : codecForExtension(path);
}

/// What a pipe gets, and a file in a folder, where --to doesn't say it; nullptr: that of the input.
const CodecRow* usualFormat(const ImageFormats& formats) {
    const std::string_view name = formats.only.empty() ? formats.start : formats.only;
    return name.empty() ? nullptr : &formatOfName(name);
}

struct ImageJob {
    std::string in;
    std::string out;
    const CodecRow* format; ///< of a pipe; a file's is that of its extension; nullptr: that of the input
};

tl::unexpected<Error> wrongImageCall(Sentence sentence, Location where = {}) {
    return fail(ErrorCode::OutOfRange, std::move(sentence), std::move(where));
}

Result<std::vector<ImageJob>> planOfTwo(const ImageFiles& files, const ImageFormats& formats,
                                        const CodecRow* format) {
    if (files.files.size() == 1)
        return wrongImageCall("OUT is missing: expected IN OUT, or IN... -o DIR");
    if (files.files.size() > 2)
        return wrongImageCall(Sentence("expected IN OUT, or IN... -o DIR, found {0}",
                                       Sentence::plural("{0} file", "{0} files", files.files.size())));
    const std::string& in = files.files[0];
    const std::string& out = files.files[1];
    if (const CodecRow* named = codecForExtension(out);
        format != nullptr && named != nullptr && named != format)
        return wrongImageCall(Sentence("expected the format of OUT, whose extension says {0}, found {1}",
                                       named->name, format->name),
                              atOption("--to"));
    if ((files.report || files.json) && isStandardOutput(out))
        return standardOutputIsTaken(files.json ? "--json" : "--report");
    return std::vector{ImageJob{in, out, format != nullptr ? format : usualFormat(formats)}};
}

Result<std::string> nameIn(const std::string& in, const ImageFormats& formats, const CodecRow* format) {
    const std::filesystem::path name = std::filesystem::path(in).filename();
    if (isStandardInput(in))
        return wrongImageCall("has no name for a file in a folder; IN OUT writes one file",
                              inFile("standard input"));
    if (name.empty() || name == "." || name == "..")
        return wrongImageCall("expected a file's name", in);
    const CodecRow* said = format != nullptr ? format : usualFormat(formats);
    const CodecRow& written = said != nullptr ? *said : writtenAs(formatOfFile(in));
    const bool keeps = format == nullptr && formats.only.empty() && &written == codecForExtension(in);
    return keeps ? name.string() : name.stem().string() + extensionsOf(written).front();
}

Result<std::vector<ImageJob>> planOfFolder(const ImageFiles& files, const ImageFormats& formats,
                                           const CodecRow* format) {
    std::error_code ignored;
    const std::filesystem::path folder = files.folder;
    if (codecForExtension(files.folder) != nullptr && !std::filesystem::is_directory(folder, ignored))
        return wrongImageCall(
            Sentence("expected a folder, found \"{0}\"; IN OUT writes one file", files.folder), "--out");
    if (format == nullptr && formats.named)
        return wrongImageCall(
            Sentence("--to is missing: with -o it says the format, one of {0}", formatNames()));
    std::vector<ImageJob> jobs;
    std::map<std::string, std::string> makers; // of each name
    for (const std::string& in : files.files) {
        const Result<std::string> name = nameIn(in, formats, format);
        if (!name)
            return fail(name.error());
        if (const auto [other, isNew] = makers.emplace(*name, in); !isNew)
            return wrongImageCall(Sentence("\"{0}\" and \"{1}\" would both become {2}", other->second, in,
                                           (folder / *name).string()),
                                  "--out");
        jobs.push_back({in, (folder / *name).string(), codecForExtension(*name)});
    }
    return jobs;
}

Result<std::vector<ImageJob>> planInPlace(const ImageFiles& files) {
    std::vector<ImageJob> jobs;
    for (const std::string& in : files.files) {
        const Result<const CodecRow*> format = imageFormatOf(in, {}, {}, "IN");
        if (!format)
            return fail(format.error());
        jobs.push_back({in, in, *format});
    }
    return jobs;
}

Result<std::vector<ImageJob>> planOf(const ImageFiles& files, const ImageFormats& formats) {
    const CodecRow* format = nullptr;
    if (!files.format.empty()) {
        const Result<const CodecRow*> named = formatNamed(files.format);
        if (!named)
            return fail(named.error());
        format = *named;
    }
    if (files.inPlace)
        return planInPlace(files);
    return files.folder.empty() ? planOfTwo(files, formats, format) : planOfFolder(files, formats, format);
}

/// No image may take the place of another one, or of one that is read, even of one that is read before. In
/// place each takes that of its own, once.
Result<void> checkImagesApart(const std::vector<ImageJob>& jobs, const ImageFiles& files) {
    const char* option = files.inPlace ? "--in-place" : files.folder.empty() ? "OUT" : "--out";
    std::vector<NamedOutput> outputs;
    std::vector<std::string> inputs;
    for (const ImageJob& each : jobs) {
        outputs.push_back({option, each.out});
        if (!files.inPlace)
            inputs.push_back(each.in);
    }
    return checkOutputsApart(outputs, inputs);
}

/// What is told of the pictures that were written, and of those that weren't.
struct ToldImages {
    std::string text;
    Json written = Json::array();
};

Json levelsJson(const TextureReport& report) {
    Json levels = Json::array();
    for (const LevelReport& level : report.levels) {
        Json entry{{"level", level.number}, {"width", level.width}, {"height", level.height},
                   {"depth", level.depth},  {"faces", level.faces}, {"bytes", level.bytes}};
        if (level.psnr) { // JSON has no infinity
            entry["psnr"] = std::isfinite(*level.psnr) ? Json(*level.psnr) : Json();
            entry["components"] = level.components;
        }
        levels.push_back(std::move(entry));
    }
    return levels;
}

Json lossesJson(const std::vector<Loss>& losses) {
    Json list = Json::array();
    for (const Loss& loss : losses) {
        list.push_back({{"what", loss.what}, {"ofPixels", loss.ofPixels}});
        list.back().update(messageJson(loss.sentence));
    }
    return list;
}

void tellOf(ToldImages& told, const ImageJob& job, const MadeImage& made, const CodecRow& format,
            std::size_t bytes, bool alone) {
    const TextureImage& texture = made.texture;
    const Surface& base = texture.surface(0, 0);
    // Formats of one picture take no more than that.
    const bool all = format.name == "DDS";
    const int levels = all ? texture.levels : 1;
    const int faces = all ? texture.faces : 1;
    const int layers = all ? texture.layers : 1;
    Json entry{{"input", inputName(job.in)},
               {"file", job.out},
               {"format", format.name},
               {"width", widthOf(base)},
               {"height", heightOf(base)},
               {"depth", all ? depthOf(base) : 1},
               {"layers", layers},
               {"faces", faces},
               {"levelCount", levels},
               {"bytes", bytes},
               {"losses", lossesJson(made.losses)}};
    if (made.report)
        entry["report"] = {{"levels", levelsJson(*made.report)},
                           {"bytes", made.report->bytes},
                           {"ratioToBase", made.report->ratioToBase},
                           {"shareOfRgba8", made.report->shareOfRgba8},
                           {"shareOfRgb8", made.report->shareOfRgb8}};
    told.written.push_back(std::move(entry));
    if (!made.report || !alone)
        told.text += fmt::format("{} -> {}: {}, {} × {}, {}{}{}, {}\n", printable(inputName(job.in)),
                                 printable(job.out), format.name, widthOf(base), heightOf(base),
                                 layers > 1 ? fmt::format("{} layers, ", layers) : std::string(),
                                 faces > 1 ? fmt::format("{} faces, ", faces) : std::string(),
                                 Sentence::plural("{0} level", "{0} levels", levels),
                                 Sentence::plural("{0} byte", "{0} bytes", bytes));
    if (made.report)
        told.text += describe(*made.report);
    if (!made.losses.empty())
        told.text += fmt::format("lost: {}\n", printable(allLost(made.losses)));
}

struct WrittenImage {
    MadeImage image;
    const CodecRow* format;
    std::size_t bytes;
};

/// Adds what writing loses to what making has lost, and refuses where that isn't allowed.
Result<void> settleLosses(const ImageJob& job, const CodecRow& format, bool allowed, MadeImage& made) {
    std::ranges::move(lossesIn(made.texture, format.name), std::back_inserter(made.losses));
    const std::string lost = pixelsLost(made.losses);
    if (!lost.empty() && !allowed)
        return fail(
            ErrorCode::Unsupported,
            Sentence("as {0} it would lose something: {1}; --lossy writes it anyway", format.name, lost),
            inFile(inputName(job.in)));
    if (!made.losses.empty())
        warn({ErrorCode::Unsupported, Sentence("lost in {0}: {1}", format.name, allLost(made.losses)),
              inFile(inputName(job.in))});
    return {};
}

/// `opened`: the output, where there is one; else the job's is opened when there is something to write.
Result<WrittenImage> makeImage(const ImageJob& job, const std::optional<ImageOutput>& opened, bool lossy,
                               const MakeImage& make) {
    Result<MadeImage> made = make(job.in);
    if (!made)
        return fail(made.error());
    const bool keepsFormat = job.format == nullptr && codecForExtension(job.out) == nullptr;
    const CodecRow& format = keepsFormat ? writtenAs(&formatOfName(made->texture.format))
                             : opened    ? *opened->format
                                         : *job.format;
    if (const Result<void> settled = settleLosses(job, format, lossy, *made); !settled)
        return fail(settled.error());
    const Result<Bytes> bytes = format.encode(made->texture, made->options);
    if (!bytes)
        return fail(bytes.error().code, bytes.error().message, inFile(job.out));
    const Result<void> written =
        opened ? opened->output.write(*bytes)
               : Output::open(job.out).and_then([&](const Output& output) { return output.write(*bytes); });
    if (!written)
        return fail(written.error());
    return WrittenImage{*std::move(made), &format, bytes->size()};
}

ExitCode printTold(const ImageFiles& files, const ToldImages& told) {
    if (!files.report && !files.json)
        return success;
    const Result<void> printed = print(files.json ? documentText(told.written) : told.text);
    return printed ? success : complain(printed.error());
}

} // namespace

const Option* addImageFiles(Command& command, ImageFiles& files, const ImageFormats& formats,
                            const std::string& in, const std::string& report) {
    command.usage({"IN OUT", "IN... -o DIR"});
    std::string format;
    if (!formats.only.empty())
        format = fmt::format("as {}", formats.only);
    else
        format = formats.start.empty()
                     ? fmt::format("in the format of IN, {} where that is not written", formatInItsPlace)
                     : fmt::format("as {}", formats.start);
    command.option(
        "IN", files.files,
        fmt::format(
            "{}; - for standard input. After it OUT, the file to write, with the format of its extension: "
            "{}; - for standard output, {}.",
            in, writtenExtensions(" or ", formats.only), format),
        {.required = true});
    const Option& out = command.option(
        "-o,--out", files.folder,
        "Instead of OUT: a folder for one file for each IN, with the same name and the extension of the "
        "format. Failures are reported, and the others continue.",
        {.value = "DIR"});
    if (formats.only.empty())
        command.option(
            "--to", files.format,
            fmt::format("The format if there is no extension, with -o and -. One of {}.", formatNames()),
            {.value = "FORMAT", .offers = {writtenFormats}});
    if (!formats.lossy.empty())
        command.flag("--lossy", files.lossy, std::string(formats.lossy));
    command.flag("--report", files.report, report);
    command.flag(
        "--json", files.json,
        "The report as JSON, for programs: input, file, format, width, height, depth, layers, faces, levelCount, bytes "
        "and losses of each image.");
    return &out;
}

ExitCode makeImages(const ImageFiles& files, const ImageFormats& formats, const MakeImage& make,
                    const NoteFormat& note) {
    if (const Result<void> once = checkStandardInputOnce(
            files.folder.empty() && !files.inPlace
                ? std::span(files.files).first(std::min<std::size_t>(files.files.size(), 1))
                : std::span(files.files));
        !once)
        return complain(once.error(), wrongCall);
    const Result<std::vector<ImageJob>> jobs = planOf(files, formats);
    if (!jobs)
        return complain(jobs.error(), wrongCall);
    const bool alone = files.folder.empty() && !files.inPlace;
    if (const Result<void> apart = checkImagesApart(*jobs, files); !apart)
        return complain(apart.error(), wrongCall);
    if (!files.folder.empty()) {
        if (const Result<void> possible = checkFolderWritable(files.folder); !possible)
            return complain(possible.error());
    }
    std::optional<ImageOutput> first;
    if (alone) {
        const CodecRow* format = jobs->front().format;
        auto opened = openImageOutput(jobs->front().out, format != nullptr ? format->name : formatInItsPlace,
                                      formats.only, "OUT");
        if (!opened)
            return opened.error();
        first = *std::move(opened);
    }
    if (note)
        note(first ? *first->format : *jobs->front().format);

    ToldImages told;
    bool allDone = true;
    for (const ImageJob& job : *jobs) {
        const bool lossy = files.lossy || formats.lossy.empty();
        const Result<WrittenImage> done = makeImage(job, first, lossy, make);
        if (!done && done.error().code == ErrorCode::Cancelled)
            return complainInterrupted();
        if (!done) {
            allDone = false;
            static_cast<void>(complain(done.error()));
            continue;
        }
        tellOf(told, job, done->image, *done->format, done->bytes, alone);
    }
    if (const ExitCode printed = printTold(files, told); printed != success)
        return printed;
    return allDone ? success : failure;
}

} // namespace texplorer::screenshot
