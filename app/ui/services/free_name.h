#pragma once

#include "texplorer/base/bytes.h"
#include "texplorer/base/result.h"
#include "texplorer/files/file_fingerprint.h"

#include <filesystem>
#include <optional>

namespace texplorer::ui {

/// Writes a file completely, under this name, or, if a file other than `replaces` has it, under the first
/// free name of "earth-2.gif", "earth-3.gif" … Returns the name of the file. Errors: those of
/// writeFileAtomically.
[[nodiscard]] Result<std::filesystem::path> writeFreely(const std::filesystem::path& wanted, ByteView bytes,
                                                        const std::optional<FileFingerprint>& replaces = {});

} // namespace texplorer::ui
