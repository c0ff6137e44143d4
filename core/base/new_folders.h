#pragma once

#include <filesystem>
#include <vector>

namespace texplorer {

/// Folders that are made for what will be put into them: at its end those that are still empty go again.
class NewFolders {
public:
    /// With those above it. false: it can't be made, and errno says why; what is there already is fine.
    [[nodiscard]] bool make(const std::filesystem::path& folder);

    /// Empty ones stay, too.
    void keep() { made_.clear(); }

    NewFolders() = default;
    NewFolders(const NewFolders&) = delete;
    NewFolders& operator=(const NewFolders&) = delete;
    ~NewFolders();

private:
    std::vector<std::filesystem::path> made_; ///< those above others first
};

} // namespace texplorer
