#pragma once

#include "core/suite/plan.h"
#include "core/texture/image_source.h"

#include <map>
#include <memory>

namespace texplorer::suite {

/// A scene as a case begins: with everything edited; `images` knows where its files are.
struct CaseScene {
    Scene scene;
    ImageSource images;
    std::filesystem::path file{}; ///< of the scene; empty: none

    /// Reads the images that aren't there yet: `images.load` where it has a folder.
    [[nodiscard]] Result<void> load();
};

/// One that an entry names, without edits. Errors: NotFound where the file, example or lesson is missing;
/// what is wrong in it. Images of a lesson are loaded, of a file not yet.
[[nodiscard]] Result<CaseScene> readScene(const Suite& suite, const SceneSource& source);

/// A case's, with the edits of its entry and of its axes.
[[nodiscard]] Result<CaseScene> openScene(const Plan& plan, const Case& of);

/// In the name of a golden it stands for the driver.
inline constexpr std::string_view driverPlace = "{driver}";

/// What a case is held against on a driver: files that are accepted, whether they are there or not; empty:
/// the reference. The first is the one that --update writes. Relative to the suite's folder.
[[nodiscard]] std::vector<std::string> goldensOf(const Plan& plan, const Case& of,
                                                 std::string_view rendererString);

/// The same of every driver, with driverPlace left in the names.
[[nodiscard]] std::vector<std::string> goldensOfAnyDriver(const Plan& plan, const Case& of);

/// Reads what an outcome depends on, each file once as long as it stays the same.
class Fingerprints {
public:
    Fingerprints();
    Fingerprints(const Fingerprints&) = delete;
    Fingerprints& operator=(const Fingerprints&) = delete;
    ~Fingerprints();

    /// 32 hex digits: of the scene with its edits, its image files, size, time, renderer, goldens, mask, rule
    /// and bounds, and of `with`: the program's version and the driver. What can't be read is in it, too, as
    /// what it is.
    [[nodiscard]] std::string of(const Plan& plan, const Case& each, std::string_view with,
                                 std::string_view rendererString);

private:
    struct Cache;
    std::unique_ptr<Cache> cache_;
};

} // namespace texplorer::suite
