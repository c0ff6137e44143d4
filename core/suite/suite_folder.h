#pragma once

#include "core/suite/suite.h"

namespace texplorer::suite {

/// How many files and folders are looked at.
inline constexpr std::size_t maxListedFiles = 200'000;

/// The suites of what `texshot test` is given: a suite's file; or every *.suite.json below a folder, in the
/// order of their names, called by their paths ("ci/textures"); or, where there is none, one suite of every
/// scene X.json, whose golden is X.png beside it: drawn as large as that, or, where it isn't there yet, as
/// PictureSize has it. Other JSON is a scene if it has such a picture. Links to folders are not followed.
/// Errors: those of readSuite; NotFound where a folder has neither; TooLarge.
[[nodiscard]] Result<std::vector<Suite>> suitesAt(const std::filesystem::path& fileOrFolder);

/// Whether a name is relative and stays in its folder as it is spelled: OutOfRange, with the name.
[[nodiscard]] Result<void> checkInside(std::string_view name);

/// Whether a path, from the current folder, leads to a file below `folder`: OutOfRange. The file need not be
/// there.
[[nodiscard]] Result<void> checkStays(const std::filesystem::path& folder, const std::filesystem::path& file);

/// checkInside, and the same on the disk: links that lead out of `folder` are refused, too. The file need not
/// be there.
[[nodiscard]] Result<std::filesystem::path> pathInside(const std::filesystem::path& folder,
                                                       std::string_view name);

} // namespace texplorer::suite
