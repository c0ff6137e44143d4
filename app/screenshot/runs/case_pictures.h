#pragma once

// The pictures of a case in the folder of a report.

#include "texplorer/base/result.h"
#include "texplorer/codec/common/write_options.h"
#include "texplorer/image/image.h"
#include "texplorer/suite/record.h"

#include <filesystem>
#include <optional>
#include <span>
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

/// Removes the pictures that another run has left there, but for those of these cases. Nothing else is
/// touched: what has another name, or is no file.
void removePictures(const std::filesystem::path& folder, std::span<const suite::CaseRecord> keep = {});

/// Copies a record's pictures with their pixels from the folder of its report to another one; those that
/// aren't there are taken out of the record. So are those that are no PNG files, or links to some, each with
/// a sentence in `problems`: a record and its folder come from outside, and the report may be published.
[[nodiscard]] Result<void> copyPictures(const std::filesystem::path& from, const std::filesystem::path& to,
                                        suite::CaseRecord& record, std::vector<std::string>& problems);

} // namespace texplorer::screenshot
