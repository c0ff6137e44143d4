#pragma once

#include <filesystem>
#include <vector>

namespace texplorer {

/// Creates folders for files. The destructor removes those that are still empty.
class NewFolders {
public:
    /// Creates the folder and its parents; existing ones are fine. Returns false and leaves errno on failure.
    [[nodiscard]] bool make(const std::filesystem::path& folder);

    /// Keeps empty folders, too.
    void keep() { made_.clear(); }

    NewFolders() = default;
    NewFolders(const NewFolders&) = delete;
    NewFolders& operator=(const NewFolders&) = delete;
    ~NewFolders();

private:
    std::vector<std::filesystem::path> made_; ///< parents first
};

} // namespace texplorer
