#pragma once

// Pairs of PNG files of any program, in two folders.

#include "texplorer/base/result.h"

#include <filesystem>
#include <string>
#include <vector>

namespace texplorer::suite {

inline constexpr std::size_t maxPicturePairs = 100'000;

/// A file name, and which of the folders have it.
struct PicturePair {
    std::string name; ///< relative to each folder: "menus/main.png"
    bool hasActual = false;
    bool hasGolden = false;
    std::uint64_t pixels = 0; ///< of the larger one, by the headers

    bool operator==(const PicturePair&) const = default;
};

/// Lists all *.png in two folders and their subfolders, sorted by name. Links to folders are not followed;
/// files that are links out of their folder are listed, but refused when they are read. Errors: NotFound,
/// Unreadable, TooLarge, OutOfRange if neither has pictures. `leftOut`: a folder in one of them to skip, such
/// as a report's.
[[nodiscard]] Result<std::vector<PicturePair>> pairPictures(const std::filesystem::path& actual,
                                                            const std::filesystem::path& golden,
                                                            const std::filesystem::path& leftOut = {});

} // namespace texplorer::suite
