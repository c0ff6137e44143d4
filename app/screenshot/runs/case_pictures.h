#pragma once

// The pictures of a case in the folder of a report.

#include "core/base/result.h"
#include "core/codec/common/write_options.h"
#include "core/image/image.h"
#include "core/suite/record.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace texplorer::screenshot {

/// Below a report's folder; what isn't a picture of a case doesn't lie there.
inline constexpr const char* picturesFolder = "pictures";

struct CasePictures {
    const Image* expected = nullptr; ///< nullptr: there is none
    const Image* actual = nullptr;
    const Image* difference = nullptr;
    std::vector<PictureText> actualTexts{}; ///< within the actual picture's file
};

/// Writes them as "pictures/<file>-actual.png" and so on, each with its pixels for the page
/// (report::pixelsOf), and names them in the record. `file` is Case::file, or fileNameFor another name.
[[nodiscard]] Result<void> writePictures(const std::filesystem::path& folder, const std::string& file,
                                         const CasePictures& pictures, suite::CaseRecord& record);

/// Removes what another run has left there. Nothing else is touched: what has another name, or is no file.
void removePictures(const std::filesystem::path& folder);

/// Copies a record's pictures with their pixels from the folder of its report to another one; those that
/// aren't there are taken out of the record. Names in a record come from outside: only those that
/// writePictures gives are followed.
[[nodiscard]] Result<void> copyPictures(const std::filesystem::path& from, const std::filesystem::path& to,
                                        suite::CaseRecord& record);

} // namespace texplorer::screenshot
