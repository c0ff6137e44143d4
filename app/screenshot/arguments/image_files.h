#pragma once

#include "app/command_line/command_line.h"
#include "app/screenshot/output/answer.h"
#include "texplorer/codec/registry.h"
#include "texplorer/image/texture_image.h"
#include "texplorer/texture/texture_levels.h"

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace texplorer::screenshot {

/// IN OUT, IN... -o DIR, or IN... --in-place: the files of a command that makes a picture of each.
struct ImageFiles {
    std::vector<std::string> files;
    std::string folder;   ///< empty: the second of the files is the one to write
    bool inPlace = false; ///< each is written in its own place
    std::string format;   ///< --to; empty: as the command chooses it
    bool report = false;
    bool json = false;
    bool lossy = false;
};

/// What a command writes.
struct ImageFormats {
    std::string_view only = {};  ///< the one format; empty: each that is written
    std::string_view start = {}; ///< of a pipe and in a folder, where --to doesn't say it; empty: the
                                 ///< input's, by its content
    bool named = false;          ///< in a folder --to has to say it
    /// What --lossy allows, for its help; empty: there is no such option, because all that the command makes
    /// loses something.
    std::string_view lossy = {};
};

/// Declares IN, OUT, -o, --to, --lossy, --report and --json; -o is what it returns. `report`: what --report
/// prints.
const Option* addImageFiles(Command& command, ImageFiles& files, const ImageFormats& formats,
                            const std::string& in, const std::string& report);

/// What a command makes of an image, and how it is written.
struct MadeImage {
    TextureImage texture;
    WriteOptions options{};
    std::optional<TextureReport> report{}; ///< of its levels, for --report
    std::vector<Loss> losses{};            ///< beside those of writing `texture`
};

/// Cancelled stops all that would follow.
using MakeImage = std::function<Result<MadeImage>(const std::string& in)>;

/// Says which options have no effect with the format that is to be written.
using NoteFormat = std::function<void(const CodecRow& format)>;

/// Makes and writes one after the other. What is wrong with the call is said before anything is read; one
/// that fails is said, and the others go on. What would lose pixels fails without --lossy; what is lost is
/// always said, and stands in the JSON.
[[nodiscard]] ExitCode makeImages(const ImageFiles& files, const ImageFormats& formats, const MakeImage& make,
                                  const NoteFormat& note = {});

} // namespace texplorer::screenshot
