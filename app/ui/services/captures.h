#pragma once

#include "texplorer/base/sentence.h"
#include "texplorer/base/worker.h"
#include "texplorer/image/image.h"

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

namespace texplorer::ui {

/// The folder for pictures of the window: XDG_PICTURES_DIR in the text of user-dirs.dirs, whose paths are
/// absolute or begin with $HOME. Empty if the text has none.
[[nodiscard]] std::filesystem::path picturesFolderIn(std::string_view userDirs,
                                                     const std::filesystem::path& home);

/// The same for the current user; else "Pictures" in the home folder; else, without a home, the working
/// folder. It need not exist: the first picture creates it.
[[nodiscard]] std::filesystem::path picturesFolderOfUser();

/// Writes the picture of the window as PNG files, on its own thread if it works in the background.
class Captures {
public:
    explicit Captures(std::filesystem::path folder, When when = When::AtOnce,
                      std::function<void()> wake = {});
    Captures(const Captures&) = delete;
    Captures& operator=(const Captures&) = delete;
    ~Captures();

    /// Writes under a free name in the folder: "name.png", "name-2.png" … `image` has its bottom row first.
    void write(std::string name, Image image);

    /// A sentence for the user.
    struct News {
        Sentence text;
        bool isWritten = false; ///< else it says why not
    };

    /// The result of finished pictures, once. For several, the last one; a failure has priority.
    [[nodiscard]] std::optional<News> takeNews();

private:
    struct Job {
        std::string name;
        std::shared_ptr<const Image> image;
    };
    using Writing = Worker<Job, News>;

    std::filesystem::path folder_;
    Writing writing_;
};

} // namespace texplorer::ui
