#pragma once

#include "core/texture/image_loader.h"

#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>

namespace texplorer::ui {

struct Session;

/// Which field of an anatomy a byte belongs to: the smallest one that covers it.
class FieldMap {
public:
    FieldMap() = default;
    explicit FieldMap(const Anatomy& anatomy);

    /// An index into Anatomy::fields; nothing between them.
    [[nodiscard]] std::optional<std::size_t> at(std::size_t offset) const;

private:
    std::map<std::size_t, std::optional<std::size_t>> starts_; ///< from here on it is this field
};

/// The file that the tab "File" shows, as it is read.
struct InspectedFile {
    std::filesystem::path chosen; ///< what the user wants to look into; empty: the bound texture's file
    std::shared_ptr<const Bytes> inMemory; ///< what `shown` is where it lies in no folder
    std::filesystem::path shown;           ///< the file that `content` or `problem` is about; empty: none yet
    ImageLoader::Ticket ticket = 0;        ///< of what is awaited; 0: nothing
    std::shared_ptr<const DissectedFile> content;
    FieldMap map;
    std::string problem; ///< why the file can't be read; empty: nothing wrong
};

/// Opens the tab with a file, be it an image or damaged.
void lookInto(Session& session, std::filesystem::path file);

/// The content has arrived.
void receiveInspected(Session& session, Result<ImageLoader::Content> content);

/// Reads the file anew: it has changed.
void refreshInspected(Session& session);

/// Asks for the file that the tab is to show, if it shows another one.
void followFile(Session& session);

} // namespace texplorer::ui
