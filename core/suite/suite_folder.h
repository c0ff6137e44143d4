#pragma once

#include "texplorer/suite/suite.h"

namespace texplorer::suite {

/// The maximum number of files and folders that are visited.
inline constexpr std::size_t maxListedFiles = 200'000;

/// Returns the suites of an argument of `texshot test`: a suite's file; or every *.suite.json in a folder and
/// its subfolders, sorted by name, with their paths as names ("ci/textures"); or, if there is none, one suite
/// of every scene X.json, with X.png next to it as golden: drawn in the golden's size or, without it, in the
/// default of PictureSize. Other JSON is a scene only if it has such a picture. Links to folders are not
/// followed. Errors: those of readSuite; NotFound if a folder has neither; TooLarge.
[[nodiscard]] Result<std::vector<Suite>> suitesAt(const std::filesystem::path& fileOrFolder);

/// Checks that a name is relative and stays in its folder as spelled. Error: OutOfRange, with the name.
[[nodiscard]] Result<void> checkInside(std::string_view name);

/// Checks that a path, relative to the current folder, leads to a file in `folder`. Error: OutOfRange. The
/// file need not exist.
[[nodiscard]] Result<void> checkStays(const std::filesystem::path& folder, const std::filesystem::path& file);

/// checkInside, also on disk: links out of `folder` are refused, too. The file need not exist.
[[nodiscard]] Result<std::filesystem::path> pathInside(const std::filesystem::path& folder,
                                                       std::string_view name);

} // namespace texplorer::suite
