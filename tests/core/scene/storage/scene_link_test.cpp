#include "texplorer/scene/params/json.h"
#include "texplorer/scene/storage/scene_link.h"

#include <fmt/core.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <libdeflate.h>
#include <vector>

namespace texplorer::scene_link_test {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

/// As Python's base64.urlsafe_b64encode, without padding.
std::string encode(std::string_view bytes) {
    constexpr std::string_view letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-_";
    std::string text;
    for (std::size_t bit = 0; bit < bytes.size() * 8; bit += 6) {
        unsigned value = 0;
        for (std::size_t i = bit; i < bit + 6; ++i) {
            const bool set =
                i / 8 < bytes.size() && (static_cast<unsigned char>(bytes[i / 8]) >> (7 - i % 8) & 1U);
            value = value << 1 | static_cast<unsigned>(set);
        }
        text += letters[value];
    }
    return text;
}

std::string linkOf(std::string_view json) {
    libdeflate_compressor* packer = libdeflate_alloc_compressor(6);
    std::string packed(libdeflate_zlib_compress_bound(packer, json.size()), '\0');
    packed.resize(libdeflate_zlib_compress(packer, json.data(), json.size(), packed.data(), packed.size()));
    libdeflate_free_compressor(packer);
    return "texplorer:1:" + encode(packed);
}

Scene unusual() {
    Scene scene = defaultScene();
    scene.textures.front().wrapS = Wrap::ClampToEdge;
    scene.textures.front().borderColor = {0.25F, 0.5F, 0.75F, 1};
    scene.view.background = {0.1F, 0.2F, 0.3F, 1};
    return scene;
}

TEST(SceneLink, LeadsBackToItsScene) {
    const std::string link = writeSceneLink(unusual()).value();
    EXPECT_THAT(link, StartsWith("texplorer:1:"));
    EXPECT_LT(link.size(), 6000U);
    EXPECT_TRUE(isSceneLink(link));
    EXPECT_EQ(parseSceneLink(link).value(), unusual());
}

/// base64.urlsafe_b64encode(zlib.compress(b"{}", 9)) of Python.
TEST(SceneLink, IsWhatOthersMakeToo) {
    EXPECT_EQ(parseSceneLink("texplorer:1:eNqrrgUAAXUA-Q").value(), parseScene("{}").value());
    EXPECT_EQ(parseSceneLink(linkOf("{}")).value(), parseScene("{}").value());
}

TEST(SceneLink, MayBeBrokenIntoLines) {
    std::string link = writeSceneLink(unusual()).value();
    for (std::size_t i = 70; i < link.size(); i += 72)
        link.insert(i, "\r\n");
    EXPECT_EQ(parseSceneLink("  " + link + "\n").value(), unusual());
    EXPECT_TRUE(isSceneLink("\n texplorer:9:"));
    EXPECT_FALSE(isSceneLink("text"));
    EXPECT_FALSE(isSceneLink(""));
}

TEST(SceneLink, MayBeTheAddressOfAPage) {
    const std::string link = writeSceneLink(unusual()).value();
    for (const std::string page :
         {"https://example.org/texplorer/", "http://localhost:8000/?a=b", "file:///a.html"}) {
        EXPECT_TRUE(isSceneLink(page + '#' + link)) << page;
        EXPECT_EQ(parseSceneLink(" " + page + '#' + link).value(), unusual()) << page;
        EXPECT_FALSE(isSceneLink(page)) << page;
        EXPECT_FALSE(isSceneLink(page + "#lesson=wrap")) << page;
    }
    EXPECT_FALSE(isSceneLink("a#" + link)) << "no address";
}

struct Hostile {
    const char* name;
    std::string text;
    const char* said;
};

TEST(SceneLink, SaysWhatIsWrongWithIt) {
    const std::string good = writeSceneLink(unusual()).value();
    std::string flipped = good;
    flipped[good.size() / 2] = flipped[good.size() / 2] == 'A' ? 'B' : 'A';
    const std::vector<Hostile> rows{
        {"nothing", "", "begins with"},
        {"another text", "https://example.org", "begins with"},
        {"a later version", "texplorer:2:AAAA", "later version"},
        {"no letters of base64", "texplorer:1:*%&", "damaged"},
        {"one letter", "texplorer:1:A", "damaged"},
        {"padding", "texplorer:1:eNqrrgUAAXUA-Q==", "damaged"},
        {"cut off", good.substr(0, good.size() / 2), "damaged"},
        {"another letter", flipped, "damaged"},
        {"no scene", linkOf("[1, 2]"), "no scene"},
        {"no JSON", linkOf("{\"view\""), "no scene"},
        {"deep", linkOf(std::string(1'000'000, '[')), "no scene"},
        {"a bomb", linkOf(std::string(100'000'000, ' ')), "more than"},
        {"too long", "texplorer:1:" + std::string(maxLinkBytes, 'A'), "at most"},
    };
    for (const Hostile& row : rows) {
        const Result<Scene> read = parseSceneLink(row.text);
        ASSERT_FALSE(read) << row.name;
        EXPECT_THAT(read.error().message, HasSubstr(row.said)) << row.name;
        EXPECT_LT(read.error().message.english().size(), 400U) << row.name;
    }
}

} // namespace
} // namespace texplorer::scene_link_test
