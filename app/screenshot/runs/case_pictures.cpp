#include "app/screenshot/runs/case_pictures.h"

#include "texplorer/codec/png/png.h"
#include "texplorer/files/directory_listing.h"
#include "texplorer/files/file_io.h"
#include "texplorer/report/report_files.h"

#include <fmt/core.h>

#include <array>
#include <fcntl.h>
#include <set>
#include <string_view>
#include <sys/stat.h>

namespace texplorer::screenshot {
namespace {

namespace fs = std::filesystem;

struct Kind {
    std::string_view ending;
    const Image* CasePictures::*image;
    std::string suite::CaseRecord::*name;
};

constexpr std::array kinds{
    Kind{"-expected.png", &CasePictures::expected, &suite::CaseRecord::expectedPicture},
    Kind{"-actual.png", &CasePictures::actual, &suite::CaseRecord::actualPicture},
    Kind{"-difference.png", &CasePictures::difference, &suite::CaseRecord::differencePicture},
};
constexpr std::string_view pixelsEnding = ".js";

/// A file of this name within "pictures/".
bool isPictureName(std::string_view name) {
    if (name.ends_with(pixelsEnding))
        name.remove_suffix(pixelsEnding.size());
    for (const Kind& kind : kinds) {
        if (name.ends_with(kind.ending) && name.find('/') == std::string_view::npos &&
            !name.starts_with('.') && name.find('\0') == std::string_view::npos)
            return true;
    }
    return false;
}

Descriptor openPictures(const fs::path& folder) {
    const fs::path pictures = folder / picturesFolder;
    return Descriptor(::open(pictures.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC | O_NOFOLLOW));
}

/// A picture beside a record, by its name within "pictures/".
Result<Bytes> readPicture(const fs::path& folder, const std::string& name) {
    const std::string path = (folder / picturesFolder / name).string();
    const Descriptor directory = openPictures(folder);
    struct stat info {};
    if (!directory.valid() || ::fstatat(directory.get(), name.c_str(), &info, AT_SYMLINK_NOFOLLOW) != 0)
        return fail(ErrorCode::NotFound, "there is no such picture", inFile(path));
    const Error noPicture{ErrorCode::Malformed, N_("expected a PNG file, found something else: left out"),
                          inFile(path)};
    if (!S_ISREG(info.st_mode))
        return fail(noPicture);
    const Descriptor file(
        ::openat(directory.get(), name.c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_NOCTTY | O_CLOEXEC));
    Result<Bytes> bytes = readOpened(file, path);
    if (bytes && !decodePng(*bytes, {.pixels = false}))
        return fail(noPicture);
    return bytes;
}

/// What is in a file's place, even a link, goes: it isn't followed.
Result<void> place(const fs::path& file, ByteView bytes) {
    std::error_code ignored;
    fs::remove(file, ignored);
    return writeFileAtomically(file, bytes);
}

/// The pixels for the page are without the texts, which may be longer than they are.
Result<void> writeOne(const fs::path& folder, const std::string& name, const Image& image,
                      const std::vector<PictureText>& texts) {
    const Result<Bytes> png = encodePng(image);
    if (!png)
        return fail(png.error());
    const Result<Bytes> file = texts.empty() ? png : encodePng(image, {.texts = texts});
    if (!file)
        return fail(file.error());
    if (const Result<void> written = place(folder / name, *file); !written)
        return written;
    const report::File pixels = report::pixelsOf(name, *png);
    return place(folder / pixels.name, pixels.bytes);
}

} // namespace

Result<void> writePictures(const fs::path& folder, const std::string& file, const CasePictures& pictures,
                           suite::CaseRecord& record) {
    const std::vector<PictureText> none;
    for (const Kind& kind : kinds) {
        const Image* image = pictures.*kind.image;
        if (image == nullptr)
            continue;
        const bool isActual = kind.image == &CasePictures::actual;
        const std::string name = fmt::format("{}/{}{}", picturesFolder, file, kind.ending);
        if (const Result<void> written =
                writeOne(folder, name, *image, isActual ? pictures.actualTexts : none);
            !written)
            return written;
        record.*kind.name = name;
    }
    return {};
}

void removePictures(const fs::path& folder, std::span<const suite::CaseRecord> keep) {
    const Descriptor directory = openPictures(folder);
    if (!directory.valid())
        return;
    std::set<std::string> kept;
    for (const suite::CaseRecord& record : keep) {
        for (const Kind& kind : kinds) {
            const std::string name = fs::path(record.*kind.name).filename().string();
            kept.insert({name, name + std::string(pixelsEnding)});
        }
    }
    std::vector<std::string> names;
    forEachName(directory.get(), [&](const char* name) {
        if (isPictureName(name) && !kept.contains(name))
            names.emplace_back(name);
    });
    for (const std::string& name : names)
        ::unlinkat(directory.get(), name.c_str(), 0); // a folder stays
}

Result<void> copyPictures(const fs::path& from, const fs::path& to, suite::CaseRecord& record,
                          std::vector<std::string>& problems) {
    const std::string prefix = std::string(picturesFolder) + "/";
    for (const Kind& kind : kinds) {
        std::string& name = record.*kind.name;
        if (name.empty())
            continue;
        const bool isOurs = name.starts_with(prefix) && isPictureName(name.substr(prefix.size()));
        const Result<Bytes> png =
            isOurs ? readPicture(from, name.substr(prefix.size())) : fail(ErrorCode::NotFound, {});
        if (!png) {
            if (png.error().code != ErrorCode::NotFound)
                problems.push_back(describe(png.error()));
            name.clear();
            continue;
        }
        if (const Result<void> written = place(to / name, *png); !written)
            return written;
        const report::File pixels = report::pixelsOf(name, *png);
        if (const Result<void> written = place(to / pixels.name, pixels.bytes); !written)
            return written;
    }
    return {};
}

} // namespace texplorer::screenshot
