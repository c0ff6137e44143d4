#pragma once

#include "core/base/bytes.h"
#include "core/base/file_fingerprint.h"
#include "core/base/result.h"

#include <filesystem>
#include <optional>

namespace texplorer::ui {

/// Writes a file as a whole, under this name or, where something else than `replaces` has it, under the first
/// one of "earth-2.gif", "earth-3.gif" … that is free. Returns the name that it has. Errors: those of
/// writeFileAtomically.
[[nodiscard]] Result<std::filesystem::path> writeFreely(const std::filesystem::path& wanted, ByteView bytes,
                                                        const std::optional<FileFingerprint>& replaces = {});

} // namespace texplorer::ui
