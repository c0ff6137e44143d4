#pragma once

// Whether what a program has drawn is the picture that was stored: the golden.

#include "core/base/result.h"
#include "core/compare/criterion.h"
#include "core/image/image.h"

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>

namespace texplorer {

struct GoldenOptions {
    Criterion criterion{};
    /// A picture of the same size: where it is black or wholly transparent, pixels don't count. Empty: all
    /// count.
    std::filesystem::path mask{};
    /// Where the pictures of a failure go, which is made where it is missing; empty: the current folder.
    /// Their names come from the golden's, so goldens of one name need folders of their own.
    std::filesystem::path failures{};
    bool rowsTopFirst = false; ///< of raw pixels: Vulkan's and Direct3D's order instead of OpenGL's
    bool update = false;       ///< a golden that is missing, different or unreadable is written
};

/// Whether the environment variable TEXPLORER_UPDATE_GOLDENS asks for GoldenOptions::update: it is there,
/// neither empty nor 0.
[[nodiscard]] bool goldensAreUpdated();

struct GoldenCheck {
    bool alike = false; ///< or it is now, as the golden was written
    bool written = false;
    /// What differs, where and how much; which pictures were left, a line for each; how the golden is taken
    /// over.
    std::string message;
};

/// Holds a picture against the golden, a file of any format that is read. Where it isn't there or isn't
/// alike, NAME-actual.png, NAME-expected.png and NAME-difference.png (core/compare/comparison.h: its map) lie
/// in the folder of failures afterwards, as far as there are such pictures; NAME is the golden's file without
/// its extension. What an earlier check has left under these names is removed. A golden is written as a whole
/// or not at all, in the format of its extension (core/codec/texture_file.h), its folder made where it is
/// missing.
/// Errors: OutOfRange for a framebuffer without pixels or with another number of bytes, and what
/// comparePictures says; those of loadTexture for the golden and the mask, Unsupported for one of faces or
/// slices; Unwritable, Unsupported for what can't be written.
[[nodiscard]] Result<GoldenCheck> checkGolden(const Image& framebuffer, const std::filesystem::path& golden,
                                              const GoldenOptions& options = {});

/// The same of RGBA with 8 bits each, without padding between rows, as glReadPixels gives it with
/// GL_PACK_ALIGNMENT of 4 or less: the bottom row first, unless options say otherwise.
[[nodiscard]] Result<GoldenCheck> checkGolden(int width, int height, std::span<const std::byte> rgba,
                                              const std::filesystem::path& golden,
                                              const GoldenOptions& options = {});

} // namespace texplorer
