#include "texplorer/image/shared_surface.h"

#include <gtest/gtest.h>

#include <cstddef>

namespace texplorer::shared_surface_test {
namespace {

Image grey() {
    return {PixelFormat::Luminance8, 2, 1, 1, {std::byte{7}, std::byte{9}}};
}

TEST(SharedSurface, GivesWhatWasMadeWithoutACopy) {
    SharedSurface surface(grey());
    const std::byte* const pixels = std::get<Image>(*surface).pixels.data();
    const Surface taken = std::move(surface).take();
    EXPECT_EQ(std::get<Image>(taken).pixels.data(), pixels);
    EXPECT_EQ(std::get<Image>(taken), grey());
}

TEST(SharedSurface, CopiesWhatIsLent) {
    const auto lent = std::make_shared<const Surface>(grey());
    SharedSurface surface(lent);
    const Surface taken = std::move(surface).take();
    EXPECT_NE(std::get<Image>(taken).pixels.data(), std::get<Image>(*lent).pixels.data());
    EXPECT_EQ(taken, *lent);
}

} // namespace
} // namespace texplorer::shared_surface_test
