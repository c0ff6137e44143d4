#pragma once

// Compares a drawn picture with a stored one, the golden.

#include "texplorer/base/result.h"
#include "texplorer/compare/criterion.h"
#include "texplorer/image/image.h"

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>

namespace texplorer {

struct GoldenOptions {
    Criterion criterion{};
    /// A picture of the same size: pixels where it is black or fully transparent are not compared. Empty: all
    /// are.
    std::filesystem::path mask{};
    /// The folder for the pictures of a failure, created if needed; empty: the current folder. Their names
    /// are made from the golden's, so goldens with equal names need different folders.
    std::filesystem::path failures{};
    bool rowsTopFirst = false; ///< of raw pixels: the order of Vulkan and Direct3D instead of OpenGL's
    bool update = false;       ///< writes a golden that is missing, different or unreadable
};

/// Whether the environment variable TEXPLORER_UPDATE_GOLDENS requests GoldenOptions::update: it is set, not
/// empty and not 0.
[[nodiscard]] bool goldensAreUpdated();

struct GoldenCheck {
    bool alike = false; ///< also true if the golden was written
    bool written = false;
    /// What differs, where and how much; the written pictures, one per line; and how to update the golden.
    std::string message;
};

/// Compares a picture with the golden, a file of any supported format. If the golden is missing or different,
/// writes NAME-actual.png, NAME-expected.png and NAME-difference.png (the map of
/// texplorer/compare/comparison.h), as far as these pictures exist, into the folder of failures; NAME is the
/// golden's file name without extension. Files of these names from an earlier check are removed. A golden is
/// written completely or not at all, in the format of its extension (texplorer/codec/texture_file.h); its
/// folder is created if needed. Errors: OutOfRange for a framebuffer without pixels or with a wrong number of
/// bytes, and the errors of comparePictures; those of loadTexture for the golden and the mask, Unsupported if
/// they have faces or slices; Unwritable or Unsupported for files that cannot be written.
[[nodiscard]] Result<GoldenCheck> checkGolden(const Image& framebuffer, const std::filesystem::path& golden,
                                              const GoldenOptions& options = {});

/// The same for RGBA with 8 bits each, without padding between rows, as glReadPixels returns it with
/// GL_PACK_ALIGNMENT of 4 or less: the bottom row first, unless the options say otherwise.
[[nodiscard]] Result<GoldenCheck> checkGolden(int width, int height, std::span<const std::byte> rgba,
                                              const std::filesystem::path& golden,
                                              const GoldenOptions& options = {});

} // namespace texplorer
