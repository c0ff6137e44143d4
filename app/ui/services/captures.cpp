#include "app/ui/services/captures.h"

#include "app/ui/services/free_name.h"
#include "texplorer/codec/png/png.h"
#include "texplorer/files/file_io.h"
#include "texplorer/files/user_folder.h"
#include "texplorer/image/convert.h"

#include <algorithm>
#include <cstdlib>
#include <utility>

namespace texplorer::ui {
namespace {

namespace fs = std::filesystem;

constexpr FailureWords captureFailure{N_("not enough memory for the picture"),
                                      N_("the picture can't be written")};
constexpr std::size_t maxUserDirsBytes = 64U << 10;

Captures::News captureProblem(const Error& error) {
    return {Sentence("The picture can't be written: {0}.", describe(error)), false};
}

} // namespace

fs::path picturesFolderIn(std::string_view userDirs, const fs::path& home) {
    constexpr std::string_view key = "XDG_PICTURES_DIR=\"";
    fs::path folder;
    while (!userDirs.empty()) { // the last one counts, as in a shell
        const std::string_view line = userDirs.substr(0, userDirs.find('\n'));
        userDirs.remove_prefix(std::min(userDirs.size(), line.size() + 1));
        if (!line.starts_with(key))
            continue;
        const std::string_view quoted = line.substr(key.size());
        const std::string_view value = quoted.substr(0, quoted.find('"'));
        constexpr std::string_view atHome = "$HOME/";
        if (value.starts_with(atHome))
            folder = home / value.substr(atHome.size());
        else if (value.starts_with('/'))
            folder = value;
    }
    return folder;
}

fs::path picturesFolderOfUser() {
    const fs::path config = userFolder("XDG_CONFIG_HOME", ".config");
    const char* home = std::getenv("HOME");
    std::error_code failed;
    if (!config.empty() && home) {
        const Result<std::string> text = readText(config / "user-dirs.dirs", maxUserDirsBytes);
        const fs::path folder = text ? picturesFolderIn(*text, home) : fs::path{};
        if (!folder.empty())
            return folder;
    }
    if (home && fs::is_directory(home, failed))
        return fs::path(home) / N_("Pictures");
    const fs::path working = fs::current_path(failed);
    return failed ? fs::path(".") : working;
}

Captures::Captures(fs::path folder, When when, std::function<void()> wake)
    : folder_(std::move(folder))
    , writing_(
          {when, JobOrder::Queue, captureFailure, std::move(wake)},
          [this](const Writing::Task& task) {
              std::error_code ignored; // the writing says what is wrong
              fs::create_directories(folder_, ignored);
              const Result<Bytes> bytes = encodePng(withoutAlpha(*task.job().image));
              if (!bytes)
                  return captureProblem(bytes.error());
              const Result<fs::path> written = writeFreely(folder_ / (task.job().name + ".png"), *bytes);
              return written ? News{Sentence("Written: {0}", ProperName{written->string()}), true}
                             : captureProblem(written.error());
          },
          [](const Job& /*job*/, const Error& error) { return captureProblem(error); }) {}

Captures::~Captures() {
    writing_.wait(); // what the user has asked for isn't lost with the window
}

void Captures::write(std::string name, Image image) {
    writing_.ask({std::move(name), std::make_shared<const Image>(std::move(image))});
}

std::optional<Captures::News> Captures::takeNews() {
    std::vector<News> news = writing_.take();
    if (news.empty())
        return std::nullopt;
    const auto failed =
        std::find_if(news.rbegin(), news.rend(), [](const News& each) { return !each.isWritten; });
    return std::move(failed == news.rend() ? news.back() : *failed);
}

} // namespace texplorer::ui
