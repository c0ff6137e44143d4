#pragma once

#include "app/ui/services/captures.h"
#include "app/ui/services/environment_pictures.h"
#include "app/ui/services/file_writing.h"
#include "app/ui/services/files.h"
#include "app/ui/services/lesson_work.h"
#include "app/ui/services/level_pictures.h"
#include "app/ui/services/pattern_pictures.h"
#include "app/ui/services/settings_file.h"
#include "app/ui/services/sheet_pictures.h"
#include "app/ui/services/unsaved_work.h"
#include "texplorer/emit/program_worker.h"
#include "texplorer/reference/draw_worker.h"
#include "texplorer/reference/level_map_worker.h"
#include "texplorer/reference/probe_worker.h"
#include "texplorer/texture/levels_worker.h"

#include <functional>

namespace texplorer::ui {

/// A reference to a service of the host: through a const one only its const functions can be called.
template<class T>
class ServiceRef {
public:
    ServiceRef(T& service) // NOLINT(google-explicit-constructor): as a reference
        : service_(&service) {}
    ServiceRef(T* service = nullptr) // NOLINT(google-explicit-constructor): nullptr: none
        : service_(service) {}

    T* operator->() { return service_; }
    const T* operator->() const { return service_; }
    operator T&() { return *service_; }            // NOLINT(google-explicit-constructor)
    operator T*() { return service_; }             // NOLINT(google-explicit-constructor)
    operator const T*() const { return service_; } // NOLINT(google-explicit-constructor)

private:
    T* service_;
};

/// The workers of the window. Owned by the host; must outlive the session.
struct Services {
    ServiceRef<Files> files;
    ServiceRef<LevelsWorker> levels;                ///< of the scene's textures
    ServiceRef<reference::DrawWorker> reference;    ///< of the reference's picture
    ServiceRef<reference::DrawWorker> kept;         ///< of its picture of the kept state A
    ServiceRef<reference::ProbeWorker> probe;       ///< of the pixel that is explained
    ServiceRef<reference::LevelMapWorker> levelMap; ///< of the levels that each pixel reads
    ServiceRef<PatternPictures> patterns;           ///< of the choice of patterns
    ServiceRef<LevelPictures> levelPictures;        ///< of the level shown in texture space
    ServiceRef<LessonWork> lessons;                 ///< of the open lesson
    ServiceRef<EnvironmentPictures> environments;   ///< of the table of environments
    ServiceRef<reference::ProbeWorker>
        plainProbe;                  ///< of the same pixel for that table, regardless of the texture's format
    ServiceRef<SheetPictures> sheet; ///< of the sheet of variations
    ServiceRef<emit::ProgramWorker> programs; ///< of the calls in the tab
    ServiceRef<FileWriting> writing;          ///< of sheets, animations and programs
    ServiceRef<UnsavedWork> unsaved{};        ///< nullptr: unsaved work is not kept
    ServiceRef<SettingsFile> settings{};      ///< nullptr: settings are not kept
    ServiceRef<Captures> captures{};          ///< nullptr: no pictures are written
};

/// The services of a window, which reads files with a `FilesKind`.
template<class FilesKind>
class OwnedServices {
public:
    /// `wake` is called on the workers' threads when the next frame has something new; `work`: how textures
    /// are compressed at run time.
    OwnedServices(When when, const std::function<void()>& wake, const LevelWork& work, auto&&... files)
        : when_(when)
        , wake_(wake)
        , work_(work)
        , files_(files...) {}

    [[nodiscard]] Services lend(UnsavedWork* unsaved = nullptr) {
        return {files_,   levels_,       reference_,  kept_,  probe_,    levelMap_, patterns_, levelPictures_,
                lessons_, environments_, plainProbe_, sheet_, programs_, writing_,  unsaved};
    }

private:
    When when_;
    std::function<void()> wake_;
    LevelWork work_;
    FilesKind files_;
    LevelsWorker levels_{when_, wake_, work_};
    reference::DrawWorker reference_{when_, wake_, work_};
    reference::DrawWorker kept_{when_, wake_, work_};
    reference::ProbeWorker probe_{when_, wake_, work_};
    reference::LevelMapWorker levelMap_{when_, wake_, work_};
    PatternPictures patterns_{when_, wake_};
    LevelPictures levelPictures_{when_, wake_};
    LessonWork lessons_{when_, wake_};
    EnvironmentPictures environments_{when_, wake_};
    reference::ProbeWorker plainProbe_{when_, wake_, work_};
    SheetPictures sheet_{when_, wake_, work_};
    emit::ProgramWorker programs_{when_, wake_, work_};
    FileWriting writing_{when_, wake_, work_};
};

/// Services that work in the background on their own threads. Textures that are compressed at run time are
/// kept in `cache`.
struct ServicesBeside : OwnedServices<FilesBeside> {
    explicit ServicesBeside(const std::function<void()>& wake = {}, const BlockCache& cache = {})
        : OwnedServices(When::WhenReady, wake, {cache}, wake) {}
};

/// The same without threads: every call blocks. For programs without a user.
struct ServicesAtOnce : OwnedServices<FilesAtOnce> {
    explicit ServicesAtOnce(const LevelWork& work = {})
        : OwnedServices(When::AtOnce, {}, work) {}
};

} // namespace texplorer::ui
