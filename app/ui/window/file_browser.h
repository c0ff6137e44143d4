#pragma once

#include "app/ui/model/session.h"
#include "app/ui/widgets/pictures.h"
#include "texplorer/files/file_fingerprint.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace texplorer::ui {

/// A list of a folder's entries to choose a file, or to name a file to write.
struct FileBrowser {
    struct Entry {
        std::string name;
        bool isFolder = false;
        std::uintmax_t bytes = 0;
        std::filesystem::file_time_type modified{};
        bool isOther = false; ///< has a listed extension, but `isListed` is false
    };

    std::string title;
    std::vector<std::string> extensions; ///< lower case, with the dot; others are hidden. Empty: everything
    /// Filters the files with such an extension. nullptr: all are listed.
    bool (*isListed)(const std::filesystem::path& file) = nullptr;
    bool saving = false;
    std::string suffix; ///< appended to a name without an extension when saving; empty: the first of them
    bool thumbnails = false; ///< shows small pictures next to the names of files
    bool showAll = false;    ///< lists files with other extensions as well

    std::filesystem::path folder;
    std::vector<Entry> entries;
    std::string typed; ///< the name or path in the text field
    int marked = -1;   ///< index into entries
    Sentence error;    ///< why the folder or the file is not available; empty: no error
    std::optional<FileFingerprint> overwrites; ///< the file that the user has agreed to replace
    bool focusName = false;                    ///< the text field gets the keyboard in the next frame
    bool scrollToMarked = false;
};

/// Reads a folder: folders first, then files, by name. On failure the browser stays in its folder and shows
/// the error.
void enterFolder(FileBrowser& browser, const std::filesystem::path& folder);

/// Prepares the browser for a dialog; it starts in its last folder, or else in that of `startFile`.
void beginBrowsing(FileBrowser& browser, std::string title, std::vector<std::string> extensions, bool saving,
                   const std::filesystem::path& startFile,
                   bool (*isListed)(const std::filesystem::path& file) = nullptr);

enum class Browsing { Open, Chosen, Cancelled };

/// Draws the browser as a modal window. `chosen` is set with Browsing::Chosen.
[[nodiscard]] Browsing drawFileBrowser(const Session& session, FileBrowser& browser, const Pictures& pictures,
                                       std::filesystem::path& chosen);

} // namespace texplorer::ui
