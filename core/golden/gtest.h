#pragma once

//     EXPECT_TRUE(texplorer::matchesGolden(width, height, pixels, "golden/start.png"));
//
// With TEXPLORER_UPDATE_GOLDENS=1 in the environment, missing or different goldens are written.

#include "texplorer/golden/golden.h"

#include <gtest/gtest.h>

namespace texplorer {

/// Converts the result of checkGolden for GoogleTest.
[[nodiscard]] inline testing::AssertionResult assertionOf(const Result<GoldenCheck>& check) {
    if (!check)
        return testing::AssertionFailure() << describe(check.error());
    return testing::AssertionResult(check->alike) << check->message;
}

/// `image` is a framebuffer of any format, bottom row first. See checkGolden.
[[nodiscard]] inline testing::AssertionResult
matchesGolden(const Image& framebuffer, const std::filesystem::path& golden, GoldenOptions options = {}) {
    options.update |= goldensAreUpdated();
    return assertionOf(checkGolden(framebuffer, golden, options));
}

/// Pixels as returned by glReadPixels for GL_RGBA and GL_UNSIGNED_BYTE, the bottom row first unless the
/// options say otherwise. See checkGolden.
[[nodiscard]] inline testing::AssertionResult matchesGolden(int width, int height,
                                                            std::span<const std::byte> rgba,
                                                            const std::filesystem::path& golden,
                                                            GoldenOptions options = {}) {
    options.update |= goldensAreUpdated();
    return assertionOf(checkGolden(width, height, rgba, golden, options));
}

} // namespace texplorer
