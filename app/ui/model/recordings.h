#pragma once

#include "app/ui/model/file_news.h"
#include "core/animation/format.h"
#include "core/base/worker.h"
#include "core/reference/draw.h"

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>

namespace texplorer::ui {

struct Session; // see session.h

/// How long a recording is that nothing else says it of.
inline constexpr float usualSeconds = 4;

/// What is recorded, and how.
struct RecordingChoice {
    animation::Format format = animation::Format::WebP;
    float begin = 0;                ///< seconds
    std::optional<float> seconds{}; ///< nothing: as long as the key frames are
    float perSecond = 25;           ///< pictures
    int width = 640;                ///< of each, in pixels
    int height = 400;
};

/// Writes animations, whose pictures the reference draws: the same as those of
/// "texshot animate --renderer reference". All functions are to be called from one thread.
class Recordings {
public:
    /// `wake` is called on the thread that works whenever there is news. `levels`: how textures are
    /// compressed at run time.
    explicit Recordings(When when, std::function<void()> wake = {}, LevelWork levels = {});
    Recordings(const Recordings&) = delete;
    Recordings& operator=(const Recordings&) = delete;
    ~Recordings(); ///< what isn't written by then never is

    struct Order {
        reference::DrawRequest picture; ///< the first one, with its time
        animation::Format format{};
        double seconds = 1;
        double perSecond = 1;
        std::filesystem::path file; ///< is replaced as a whole, or stays

        [[nodiscard]] std::size_t pictures() const; ///< at least 1
    };

    /// One after the other.
    void write(Order order);
    /// Of the one that is drawn; nothing: none is.
    [[nodiscard]] std::optional<FileProgress> progress() const;
    /// Gives up all that isn't written yet: its files stay what they were.
    void cancel();
    /// What there is to say of the last one that was written, or couldn't be: once.
    [[nodiscard]] std::optional<FileNews> takeNews();
    /// Sleeps until all is written.
    void wait() const;

private:
    struct State;
    std::unique_ptr<State> state_;
};

/// How long it will be, in seconds.
[[nodiscard]] float recordedSeconds(const Session& session);

/// What the choice makes of the scene as it is. Errors: the format can't have so many pictures a second or
/// such an extent, they are too many, it ends too late.
[[nodiscard]] Result<Recordings::Order> recordingOrder(const Session& session);

/// "earth.webp"
[[nodiscard]] std::string recordingFileName(const Session& session);

/// Writes it. Errors: those, and a name that isn't the format's.
[[nodiscard]] Result<void> saveRecording(Session& session, const std::filesystem::path& file);

} // namespace texplorer::ui
