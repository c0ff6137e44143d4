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

    bool operator==(const PicturePair&) const = default;
};

/// Every *.png below two folders, in the order of their names. Links to folders are not followed, and files
/// that are links out of their folder are refused by name. Errors: NotFound, Unreadable, TooLarge, OutOfRange
/// where neither has any picture.
[[nodiscard]] Result<std::vector<PicturePair>> pairPictures(const std::filesystem::path& actual,
                                                            const std::filesystem::path& golden);

} // namespace texplorer::suite
