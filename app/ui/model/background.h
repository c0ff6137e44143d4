#pragma once

#include "app/ui/model/thumbnails.h"
#include "core/base/file_watch.h"
#include "core/reference/draw_worker.h"
#include "core/reference/probe_worker.h"
#include "core/texture/image_loader.h"
#include "core/texture/levels_worker.h"

namespace texplorer::ui {

/// What works beside the window, on threads of its own. The host makes one and lends it to the session;
/// `wake` is called on those threads when there is news for the next frame.
struct Background {
    /// Textures that are compressed at run time are kept in `cache`.
    explicit Background(const std::function<void()>& wake = {}, const BlockCache& cache = {})
        : levels(LevelsWorker::When::WhenReady, wake, {cache})
        , loader(wake)
        , thumbnails(wake)
        , watch(wake)
        , reference(reference::DrawWorker::When::WhenReady, wake, {cache})
        , probe(reference::ProbeWorker::When::WhenReady, wake, {cache}) {}

    LevelsWorker levels; ///< of the scene's textures
    ImageLoader loader;  ///< what the user wants to see
    Thumbnails thumbnails;
    FileWatch watch;                 ///< of every file that is loaded
    reference::DrawWorker reference; ///< of the reference's picture
    reference::ProbeWorker probe;    ///< of the pixel that is explained
};

} // namespace texplorer::ui
