#pragma once

#include "texplorer/texture/image_loader.h"

#include <filesystem>

namespace texplorer::ui {

struct Session;

/// Opens the tab with a file, which may be damaged.
void lookInto(Session& session, std::filesystem::path file);

/// The content has arrived.
void receiveInspected(Session& session, Result<ImageLoader::Content> content);

/// Reads the file again, because it has changed.
void refreshInspected(Session& session);

/// Requests the file that the tab should show, if it shows another one.
void followFile(Session& session);

} // namespace texplorer::ui
