#pragma once

#include "app/ui/model/file_writing.h"
#include "core/animation/format.h"
#include "core/reference/draw.h"

#include <filesystem>
#include <optional>
#include <string>

namespace texplorer::ui {

struct Session; // see session.h

/// How long a recording is that nothing else says it of.
inline constexpr float usualSeconds = 4;

/// What of a document is recorded.
struct RecordedTime {
    float begin = 0;                ///< seconds
    std::optional<float> seconds{}; ///< nothing: as long as the key frames are
};

/// What is recorded, and how.
struct RecordingChoice : RecordedTime {
    animation::Format format = animation::Format::WebP;
    float perSecond = 25; ///< pictures
    int width = 640;      ///< of each, in pixels
    int height = 400;
};

/// What an animation is made of. Its pictures are those of "texshot animate --renderer reference".
struct Recording {
    reference::DrawRequest picture; ///< the first one, with its time
    animation::Format format{};
    double seconds = 1;
    double perSecond = 1;

    [[nodiscard]] std::size_t pictures() const; ///< at least 1
};

/// How long it will be, in seconds.
[[nodiscard]] float recordedSeconds(const Session& session);

/// What the choice makes of the scene as it is. Errors: the format can't have so many pictures a second or
/// such an extent, they are too many, it ends too late.
[[nodiscard]] Result<Recording> recordingOf(const Session& session);

/// The file that it becomes.
[[nodiscard]] FileOrder fileOrder(Recording recording, std::filesystem::path file);

/// "earth.webp"
[[nodiscard]] std::string recordingFileName(const Session& session);

/// Has it written. Errors: those of recordingOf, and a name that isn't the format's.
[[nodiscard]] Result<void> saveRecording(Session& session, const std::filesystem::path& file,
                                         const std::optional<FileFingerprint>& replaces = {});

} // namespace texplorer::ui
