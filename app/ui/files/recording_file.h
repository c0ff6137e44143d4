#pragma once

#include "app/ui/services/file_writing.h"
#include "texplorer/animation/format.h"
#include "texplorer/reference/draw.h"

#include <filesystem>
#include <optional>
#include <string>

namespace texplorer::ui {

struct Session; // see session.h

/// The default length of a recording.
inline constexpr float usualSeconds = 4;

/// The inputs of an animation. Its pictures are those of "texshot animate --renderer reference".
struct Recording {
    reference::DrawRequest picture; ///< the first one, with its time
    animation::Format format{};
    double seconds = 1;
    double perSecond = 1;

    [[nodiscard]] std::size_t pictures() const; ///< at least 1
};

/// The length of the recording in seconds.
[[nodiscard]] float recordedSeconds(const Session& session);

/// The recording of the current scene with these options. Errors: the format does not support this number of
/// pictures per second or this extent, there are too many pictures, it ends too late.
[[nodiscard]] Result<Recording> recordingOf(const Session& session);

/// The order for its file.
[[nodiscard]] FileOrder fileOrder(Recording recording, std::filesystem::path file);

/// "earth.webp"
[[nodiscard]] std::string recordingFileName(const Session& session);

/// Writes it. Errors: those of recordingOf, and a name that is not valid for the format.
[[nodiscard]] Result<void> saveRecording(Session& session, const std::filesystem::path& file,
                                         const std::optional<FileFingerprint>& replaces = {});

} // namespace texplorer::ui
