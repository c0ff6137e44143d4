#include "app/screenshot/arguments/picture_argument.h"

#include "app/command_line/choice_argument.h"
#include "app/screenshot/arguments/each_of_list.h"
#include "app/screenshot/arguments/option_use.h"

#include <fmt/core.h>

#include <algorithm>
#include <charconv>
#include <cmath>

namespace texplorer::screenshot {
namespace {

constexpr int maxExtent = 16384; // what Mesa's llvmpipe can draw into

std::string asArgument(view::Size size) {
    return fmt::format("{}x{}", size.width, size.height);
}

} // namespace

void addPictureArgument(Command& command, PictureArgument& argument, Several several) {
    const std::string each = several == Several::Yes ? " Of several, with commas: a picture for each." : "";
    command.option("--size", argument.size, "Of the picture, in pixels." + each,
                   {.value = "WIDTHxHEIGHT", .showsDefault = true});
    command.option("--time", argument.time, "The scene's time in seconds, for animated scenes." + each,
                   {.value = "SECONDS", .showsDefault = true});
    argument.ofReference = {
        &command.option(
            "--anisotropy", argument.anisotropy,
            "How the reference filters a texture with max anisotropy above 1, which OpenGL does not define." +
                explainChoices<reference::AnisotropyMethod>(),
            {.value = "METHOD", .showsDefault = true, .offers = {choiceNames<reference::AnisotropyMethod>}}),
        &command.option(
            "--rho", argument.rho,
            "How the reference computes rho, the texels per pixel that select mip levels, for a texture "
            "with max anisotropy 1. OpenGL 2.1, section 3.8.8, allows a range." +
                explainChoices<reference::RhoMethod>(),
            {.value = "METHOD", .showsDefault = true, .offers = {choiceNames<reference::RhoMethod>}})};
}

Result<view::Size> parsePictureSize(std::string_view text, view::Size min) {
    view::Size size;
    const char* end = text.data() + text.size();
    const auto width = std::from_chars(text.data(), end, size.width);
    if (width.ec == std::errc() && width.ptr != end && *width.ptr == 'x') {
        const auto height = std::from_chars(width.ptr + 1, end, size.height);
        if (height.ec == std::errc() && height.ptr == end && size.width >= min.width &&
            size.width <= maxExtent && size.height >= min.height && size.height <= maxExtent)
            return size;
    }
    return fail(ErrorCode::OutOfRange,
                Sentence("expected WIDTHxHEIGHT from {0} to {1}, found \"{2}\"", asArgument(min),
                         asArgument({maxExtent, maxExtent}), text),
                atOption("--size"));
}

Result<double> parseTime(std::string_view text) {
    double seconds = 0;
    const char* end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, seconds);
    if (error == std::errc() && stop == end && std::isfinite(seconds))
        return seconds;
    return fail(ErrorCode::OutOfRange, Sentence("expected a finite number of seconds, found \"{0}\"", text),
                atOption("--time"));
}

Result<std::vector<view::Size>> parsePictureSizes(std::string_view text, view::Size min) {
    return parseEach(text, "--size", [min](std::string_view each) { return parsePictureSize(each, min); });
}

Result<std::vector<double>> parseTimes(std::string_view text) {
    return parseEach(text, "--time", parseTime);
}

void noteMethodsUse(const PictureArgument& argument, bool referenceDraws) {
    for (const Option* option : argument.ofReference) {
        if (!referenceDraws && option->isGiven())
            noteUnused(option->name(), "OpenGL's driver decides, only the reference has a choice");
    }
}

bool parseNumbers(std::string_view text, std::span<int> numbers) {
    const char* at = text.data();
    const char* const end = at + text.size();
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        if (i > 0 && (at == end || *at++ != ','))
            return false;
        const auto [stop, error] = std::from_chars(at, end, numbers[i]);
        if (error != std::errc())
            return false;
        at = stop;
    }
    return at == end;
}

} // namespace texplorer::screenshot
