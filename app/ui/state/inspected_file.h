#pragma once

#include "texplorer/base/bytes.h"
#include "texplorer/base/sentence.h"
#include "texplorer/texture/image_loader.h"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>

namespace texplorer::ui {

/// Maps a byte to its field of an anatomy: the smallest field that covers it.
class FieldMap {
public:
    FieldMap() = default;
    explicit FieldMap(const Anatomy& anatomy);

    /// An index into Anatomy::fields; nothing if no field covers the byte.
    [[nodiscard]] std::optional<std::size_t> at(std::uint64_t offset) const;

private:
    std::map<std::uint64_t, std::optional<std::size_t>> starts_; ///< the field that starts here
};

/// The file in the tab "File", as it is read.
struct InspectedFile {
    std::filesystem::path chosen; ///< the file that the user selected; empty: that of the bound texture
    std::shared_ptr<const Bytes> inMemory; ///< the content of `shown` if it is not in a folder
    std::filesystem::path shown;           ///< the file of `content` or `problem`; empty: none yet
    ImageLoader::Ticket ticket = 0;        ///< of the pending request; 0: none
    std::shared_ptr<const DissectedFile> content;
    FieldMap map;
    Sentence problem; ///< why the file cannot be read; empty: no problem
};

} // namespace texplorer::ui
