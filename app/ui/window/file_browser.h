#pragma once

#include "app/ui/model/files.h"
#include "app/ui/widgets/pictures.h"
#include "core/base/file_fingerprint.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace texplorer::ui {

/// A list of a folder's entries in which one chooses a file, or names one to be written.
struct FileBrowser {
    struct Entry {
        std::string name;
        bool isFolder = false;
        std::uintmax_t bytes = 0;
        std::filesystem::file_time_type modified{};
        bool isOther = false; ///< its extension is listed, and `isListed` says that it isn't
    };

    std::string title;
    std::vector<std::string> extensions; ///< lower case, with the dot; others are hidden. Empty: everything
    /// Of the files with such an extension: which are listed. nullptr: all.
    bool (*isListed)(const std::filesystem::path& file) = nullptr;
    bool saving = false;
    std::string suffix; ///< what a name without an extension gets when it is saved; empty: the first of them
    bool thumbnails = false; ///< whether files have a small picture beside their name
    bool showAll = false;    ///< whether files with other extensions are listed too

    std::filesystem::path folder;
    std::vector<Entry> entries;
    std::string typed; ///< the name or path in the text field
    int marked = -1;   ///< index into entries
    std::string error; ///< why the folder or the file can't be had; empty: nothing wrong
    std::optional<FileFingerprint>
        overwrites;         ///< the file that the user was asked about, and may be replaced
    bool focusName = false; ///< the text field takes the keyboard at the next frame
    bool scrollToMarked = false;
};

/// Reads a folder: folders first, then files, by name. On failure the browser stays where it was and says
/// why.
void enterFolder(FileBrowser& browser, const std::filesystem::path& folder);

/// Prepares the browser for a dialog; the folder is kept from the last time, else that of `startFile`.
void beginBrowsing(FileBrowser& browser, std::string title, std::vector<std::string> extensions, bool saving,
                   const std::filesystem::path& startFile,
                   bool (*isListed)(const std::filesystem::path& file) = nullptr);

enum class Browsing { Open, Chosen, Cancelled };

/// Draws the browser as a modal window. `chosen` is set with Browsing::Chosen.
[[nodiscard]] Browsing drawFileBrowser(FileBrowser& browser, Files& files, const Pictures& pictures,
                                       std::filesystem::path& chosen);

} // namespace texplorer::ui
