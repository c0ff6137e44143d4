#pragma once

#include "app/command_line/command_line.h"
#include "app/view/frame.h"
#include "texplorer/reference/sampling/lod.h"

#include <span>
#include <vector>

namespace texplorer::screenshot {

/// How large a picture is, when it is taken and how, as the command line spells it.
struct PictureArgument {
    std::string size = "1280x800";
    std::string time = "0";
    std::string anisotropy = std::string(rowOf(reference::AnisotropyMethod::Probes).name);
    std::string rho = std::string(rowOf(reference::RhoMethod::Ideal).name);
    std::vector<const Option*> ofReference{}; ///< these two
};

/// Whether there may be several sizes and times, with commas between them.
enum class Several : bool { No, Yes };

/// Declares --size, --time, --anisotropy and --rho.
void addPictureArgument(Command& command, PictureArgument& argument, Several several = Several::No);

[[nodiscard]] Result<view::Size> parsePictureSize(std::string_view text, view::Size min = {1, 1});
[[nodiscard]] Result<double> parseTime(std::string_view text);

/// With commas between them, each once.
[[nodiscard]] Result<std::vector<view::Size>> parsePictureSizes(std::string_view text,
                                                                view::Size min = {1, 1});
[[nodiscard]] Result<std::vector<double>> parseTimes(std::string_view text);

/// A note where --anisotropy or --rho changes nothing: where the reference draws nothing.
void noteMethodsUse(const PictureArgument& argument, bool referenceDraws);

/// Exactly so many whole numbers with commas between them.
[[nodiscard]] bool parseNumbers(std::string_view text, std::span<int> numbers);

} // namespace texplorer::screenshot
