#pragma once

#include "texplorer/suite/plan.h"
#include "texplorer/texture/image_source.h"

#include <map>
#include <memory>

namespace texplorer::suite {

/// The scene of a case with all edits; `images` has its folder.
struct CaseScene {
    Scene scene;
    ImageSource images;
    std::filesystem::path file{}; ///< the scene file; empty: none

    /// Reads the missing images: `images.load` if there is a folder.
    [[nodiscard]] Result<void> load();
};

/// Reads a scene of an entry, without edits. Errors: NotFound for a missing file, example or lesson; the
/// errors in it. Images of a lesson are loaded, those of a file are not.
[[nodiscard]] Result<CaseScene> readScene(const Suite& suite, const SceneSource& source);

/// The scene of a case, with the edits of its entry and axes.
[[nodiscard]] Result<CaseScene> openScene(const Plan& plan, const Case& of);

/// Stands for the driver in the name of a golden.
inline constexpr std::string_view driverPlace = "{driver}";

/// The goldens of a case on a driver, existing or not; any of them is accepted. Empty: the reference.
/// --update writes the first. Relative to the suite's folder.
[[nodiscard]] std::vector<std::string> goldensOf(const Plan& plan, const Case& of,
                                                 std::string_view rendererString);

/// The same for every driver, with driverPlace in the names.
[[nodiscard]] std::vector<std::string> goldensOfAnyDriver(const Plan& plan, const Case& of);

/// Computes fingerprints of everything that a result depends on. Reads each file once while it is unchanged.
class Fingerprints {
public:
    Fingerprints();
    Fingerprints(const Fingerprints&) = delete;
    Fingerprints& operator=(const Fingerprints&) = delete;
    ~Fingerprints();

    /// 32 hex digits: of the scene with its edits, its image files, size, time, renderer, goldens, mask, rule
    /// and bounds, and of `with`, the program's version and the driver. Unreadable files are included as
    /// such.
    [[nodiscard]] std::string of(const Plan& plan, const Case& each, std::string_view with,
                                 std::string_view rendererString);

private:
    struct Cache;
    std::unique_ptr<Cache> cache_;
};

} // namespace texplorer::suite
