#pragma once

#include "app/ui/widgets/param_parts.h"

namespace texplorer::ui {

/// The upload of the bound texture, which there must be. Switching it on is turnUploadOn().
[[nodiscard]] Owner uploadOwner(const Session& session);

/// What the program holds of the bound texture's base, and the custom upload whose call fits it.
struct UploadFacts {
    MemoryLayout held{};
    Upload fitting{};
};
[[nodiscard]] UploadFacts uploadFacts(const Session& session);

/// Makes the upload of the bound texture custom, in one edit with the format, type and alignment that fit the
/// memory: the picture stays the same.
void turnUploadOn(const Session& session);

} // namespace texplorer::ui
