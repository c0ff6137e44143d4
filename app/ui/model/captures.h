#pragma once

#include "core/base/worker.h"
#include "core/image/image.h"

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

namespace texplorer::ui {

/// Where pictures of the window go: XDG_PICTURES_DIR in the text of user-dirs.dirs, whose paths are absolute
/// or begin with $HOME. Empty where the text names none.
[[nodiscard]] std::filesystem::path picturesFolderIn(std::string_view userDirs,
                                                     const std::filesystem::path& home);

/// The same of this user; else "Pictures" at home; else, without a home, the working folder. It needn't be
/// there: the first picture makes it.
[[nodiscard]] std::filesystem::path picturesFolderOfUser();

/// Writes what the window shows as PNG files, on a thread of its own where it is beside the window.
class Captures {
public:
    explicit Captures(std::filesystem::path folder, When when = When::AtOnce,
                      std::function<void()> wake = {});
    Captures(const Captures&) = delete;
    Captures& operator=(const Captures&) = delete;
    ~Captures();

    /// Under a name that no file in the folder has: "name.png", "name-2.png" … `image` has its bottom row
    /// first.
    void write(std::string name, Image image);

    /// A sentence for the user.
    struct News {
        std::string text;
        bool isWritten = false; ///< else it says why not
    };

    /// What there is to say of those that were written, or couldn't be: once. Of several the last one, a
    /// failure before everything else.
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
