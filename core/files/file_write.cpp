// Files that appear as a whole. A draft has no name while it is written, so that nothing stays if the program
// ends; where the file system has no nameless files, it has a temporary name. The writer of a draft locks it:
// a temporary file without a lock was left by a killed program, on this or another machine.

#include "texplorer/files/draft.h"
#include "texplorer/files/file_io.h"
#include "texplorer/files/file_kind.h"
#include "texplorer/files/folder_lock.h"
#include "texplorer/files/new_folders.h"
#include "texplorer/files/open_directory.h"

#include <cerrno>
#include <fcntl.h>
#include <optional>
#include <sys/stat.h>
#include <vector>

namespace texplorer {

namespace {

namespace fs = std::filesystem;

tl::unexpected<Error> unwritable(const Sentence& what, int error, const std::string& where) {
    return fail(ErrorCode::Unwritable, Sentence("{0}: {1}", what, systemText(error)), inFile(where));
}

tl::unexpected<Error> unwritable(int error, const std::string& where) {
    return unwritable(N_("can't be written"), error, where);
}

// Where a chain of symbolic links ends, be there a file or not.
Result<fs::path> followLinks(fs::path path) {
    const fs::path asked = path;
    std::error_code error;
    for (int steps = 0; steps < 40; ++steps) {
        if (!fs::is_symlink(fs::symlink_status(path, error)))
            return path;
        const fs::path next = fs::read_symlink(path, error);
        if (error)
            return unwritable(N_("the link can't be read"), error.value(), asked);
        path = next.is_absolute() ? next : path.parent_path() / next;
    }
    return unwritable(ELOOP, asked);
}

/// A place that a file may take.
struct Place {
    fs::path folder;
    Descriptor directory; ///< the same, open
    std::string name;
    std::optional<struct stat> replaced; ///< the file that is there now
};

Result<Place> findPlace(const fs::path& path) {
    const std::string where = path.string();
    // Before links are followed by name: /dev/stdout leads to "pipe:[4711]", which is not a file name.
    struct stat info = {};
    const bool exists = ::stat(path.c_str(), &info) == 0;
    if (exists && !S_ISREG(info.st_mode))
        return fail(ErrorCode::Unwritable, Sentence("is {0}, not a file", kindName(info.st_mode)),
                    inFile(where));
    const Result<fs::path> target = followLinks(path);
    if (!target)
        return fail(target.error());
    // Replacing needs no permission on the file itself, but a read-only file is meant to stay as it is.
    if (exists && ::faccessat(AT_FDCWD, target->c_str(), W_OK, AT_EACCESS) != 0)
        return unwritable(errno, where);
    const fs::path folder = target->has_parent_path() ? target->parent_path() : fs::path(".");
    Place place{folder, openDirectory(folder), target->filename().string(), {}};
    if (!place.directory.valid())
        return unwritable(errno, where);
    if (place.name.empty())
        return unwritable(ENOENT, where);
    if (exists)
        place.replaced = info;
    return place;
}

/// The nearest folder above that exists, to write drafts in. Errors: it is no folder.
Result<fs::path> existingFolder(const fs::path& folder) {
    std::error_code error;
    fs::path above = fs::absolute(folder, error);
    while (!fs::exists(above, error) && above.has_relative_path())
        above = above.parent_path();
    if (fs::is_directory(above, error))
        return above;
    return fail(ErrorCode::Unwritable,
                Sentence("can't create the folder: {0} is not a folder", above.string()),
                inFile(folder.string()));
}

} // namespace

bool writeFully(int file, ByteView bytes) {
    while (!bytes.empty()) {
        const ssize_t put = ::write(file, bytes.data(), bytes.size());
        if (put < 0 && errno == EINTR)
            continue;
        if (put < 0)
            return false;
        bytes = bytes.subspan(static_cast<std::size_t>(put));
    }
    return true;
}

Result<void> writeFileAtomically(const fs::path& path, ByteView bytes, const BeforePlacing& beforePlacing,
                                 Leftovers leftovers) {
    const Result<Place> place = findPlace(path);
    if (!place)
        return fail(place.error());
    if (leftovers == Leftovers::Remove)
        sweepDrafts(place->directory.get());
    Draft draft(place->directory.get());
    if (!draft.write(bytes, place->replaced ? &*place->replaced : nullptr))
        return unwritable(errno, path.string());
    if (beforePlacing)
        beforePlacing();
    if (!draft.place(place->directory.get(), place->name))
        return unwritable(errno, path.string());
    return {};
}

Result<bool> writeFileIf(const fs::path& path, ByteView bytes, const MayReplace& mayReplace) {
    const Result<Place> place = findPlace(path);
    if (!place)
        return fail(place.error());
    sweepDrafts(place->directory.get());
    Draft draft(place->directory.get());
    if (!draft.write(bytes, place->replaced ? &*place->replaced : nullptr))
        return unwritable(errno, path.string());
    const FolderLock lock(place->folder);
    if (!mayReplace())
        return false;
    if (!draft.place(place->directory.get(), place->name))
        return unwritable(errno, path.string());
    return true;
}

Result<void> writeFileAtomically(const Descriptor& directory, const std::string& name, ByteView bytes,
                                 const std::string& where) {
    sweepDrafts(directory.get());
    Draft draft(directory.get(), 0600);
    if (!draft.write(bytes) || !draft.place(directory.get(), name))
        return unwritable(errno, where);
    return {};
}

Result<void> writeFolderAtomically(const fs::path& folder, std::span<const FileContent> files,
                                   const BeforePlacing& beforePlacing) {
    const Result<fs::path> existing = existingFolder(folder);
    if (!existing)
        return fail(existing.error());
    const Descriptor above = openDirectory(*existing);
    if (!above.valid())
        return unwritable(errno, folder.string());
    sweepDrafts(above.get());
    std::vector<Draft> drafts;
    drafts.reserve(files.size());
    for (const FileContent& file : files)
        if (!drafts.emplace_back(above.get()).write(file.bytes))
            return unwritable(errno, (folder / file.name).string());
    if (beforePlacing)
        beforePlacing();

    NewFolders made;
    if (!made.make(fs::absolute(folder)))
        return unwritable(N_("can't create the folder"), errno, folder.string());
    for (const FileContent& file : files) {
        const fs::path below = fs::path(file.name).parent_path();
        if (!below.empty() && !made.make(fs::absolute(folder / below)))
            return unwritable(N_("can't create the folder"), errno, (folder / below).string());
    }
    const Descriptor directory = openDirectory(folder);
    if (!directory.valid())
        return unwritable(errno, folder.string());
    std::vector<bool> isNew; // what is there already is the user's, and stays or is replaced
    isNew.reserve(files.size());
    for (const FileContent& file : files) {
        struct stat there {};
        isNew.push_back(::fstatat(directory.get(), file.name.c_str(), &there, AT_SYMLINK_NOFOLLOW) != 0);
        if (!isNew.back() && S_ISDIR(there.st_mode))
            return unwritable(EISDIR, (folder / file.name).string());
    }
    for (std::size_t i = 0; i < files.size(); ++i) {
        if (drafts[i].place(directory.get(), files[i].name))
            continue;
        const int error = errno;
        for (std::size_t placed = 0; placed < i; ++placed)
            if (isNew[placed])
                ::unlinkat(directory.get(), files[placed].name.c_str(), 0);
        return unwritable(error, (folder / files[i].name).string());
    }
    made.keep();
    return {};
}

Result<void> checkFileWritable(const fs::path& path) {
    const Result<Place> place = findPlace(path);
    if (!place)
        return fail(place.error());
    return Draft(place->directory.get()).valid() ? Result<void>() : unwritable(errno, path.string());
}

Result<void> checkFolderWritable(const fs::path& folder) {
    const Result<fs::path> existing = existingFolder(folder);
    if (!existing)
        return fail(existing.error());
    const Descriptor directory = openDirectory(*existing);
    return directory.valid() && Draft(directory.get()).valid() ? Result<void>()
                                                               : unwritable(errno, folder.string());
}

} // namespace texplorer
