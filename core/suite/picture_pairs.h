#pragma once

// The PNGs of any program, in two folders.

#include "core/base/result.h"

#include <filesystem>
#include <string>
#include <vector>

namespace texplorer::suite {

inline constexpr std::size_t maxPicturePairs = 100'000;

/// A name, and in which of the folders it is.
struct PicturePair {
    std::string name; ///< "menus/main.png", below each folder
    bool hasActual = false;
    bool hasGolden = false;
    std::uint64_t pixels = 0; ///< of the larger one, as the headers say

    bool operator==(const PicturePair&) const = default;
};

/// Every *.png below two folders, in the order of their names. Links to folders are not followed, and files
/// that are links out of their folder are listed, and refused when they are read. Errors: NotFound,
/// Unreadable, TooLarge, OutOfRange where neither has any picture. `leftOut`: a folder in one of them that is
/// none of it, as a report's.
[[nodiscard]] Result<std::vector<PicturePair>> pairPictures(const std::filesystem::path& actual,
                                                            const std::filesystem::path& golden,
                                                            const std::filesystem::path& leftOut = {});

} // namespace texplorer::suite
