#pragma once

#include "app/ui/state/settings.h"
#include "texplorer/base/bytes.h"
#include "texplorer/base/result.h"
#include "texplorer/files/file_fingerprint.h"

#include <filesystem>
#include <optional>
#include <string>

namespace texplorer::ui {

/// The student's answers in all lessons, as JSON, to keep or hand in.
[[nodiscard]] std::string answersText(const Settings& settings);

/// The same as a file, written by writeFreely.
[[nodiscard]] Result<std::filesystem::path> saveAnswers(const Settings& settings,
                                                        const std::filesystem::path& file,
                                                        const std::optional<FileFingerprint>& replaces = {});

} // namespace texplorer::ui
