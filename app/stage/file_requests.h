#pragma once

#include "texplorer/base/bytes.h"

#include <functional>
#include <string>
#include <vector>

namespace texplorer::ui {
struct Session; // see app/ui/model/session.h
}

namespace texplorer::stage {

struct NamedFile {
    std::string name; ///< without a folder
    Bytes bytes;
};

/// A file that the user wants to open.
struct FileWish {
    bool isScene = false; ///< else an image
    std::string param{};  ///< the parameter that will name the image; empty: the bound texture
};

/// How a host without folders, such as a browser, opens and saves files. Without functions the user chooses
/// files in folders.
struct FileRequests {
    /// Asks the user for files: a FilesGiven is the answer, now or later. There is none if the user cancels.
    std::function<void(const FileWish& wish)> open;
    /// Gives files to the user: the requested one first, then those that it needs. Files that take long to
    /// make are given by the host's ui::FileWriting.
    std::function<void(std::vector<NamedFile> files)> save;
};

/// Requests a file from the host if a dialog for files is open, and closes the dialog. Call it before a frame
/// is drawn.
void requestFiles(ui::Session& session, const FileRequests& host);

} // namespace texplorer::stage
