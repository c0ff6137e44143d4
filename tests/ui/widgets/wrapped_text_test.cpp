#include "app/ui/widgets/wrapped_text.h"
#include "tests/ui/workbench.h"

#include <span>
#include <string>

namespace texplorer::ui::wrapped_text_test {
namespace {

TEST(ReadablePart, LeavesOutTheMiddleOfALongWordAndTheEndOfALongText) {
    EXPECT_EQ(readablePart("a short text\nof two lines"), "a short text\nof two lines");
    const std::string name = std::string(2000, 'a') + std::string(2000, 'b') + ".png";
    const std::string shown = readablePart("cannot open /" + name + ": no such file");
    EXPECT_LT(shown.size(), 200U);
    EXPECT_TRUE(shown.starts_with("cannot open /aaaa")) << shown;
    EXPECT_TRUE(shown.ends_with("bbb.png: no such file")) << shown;
    EXPECT_NE(shown.find("…"), std::string::npos);
    std::string blanks;
    while (blanks.size() < 20'000)
        blanks += "ab ";
    EXPECT_LE(readablePart(blanks).size(), 4003U);
    std::string chinese;
    for (int i = 0; i < 300; ++i)
        chinese += "纹理";
    EXPECT_EQ(readablePart(chinese), chinese) << "a sentence without blanks is no word";
}

TEST(ReadablePart, CutsNoLetterInHalf) {
    std::string name;
    while (name.size() < 4000)
        name += "ж";
    for (const std::string& words : {name, "a" + name, name + "a"}) {
        std::string letters = readablePart(words);
        for (const std::string letter : {"ж", "…", "a"}) {
            for (std::size_t at = 0; (at = letters.find(letter)) != std::string::npos;)
                letters.erase(at, letter.size());
        }
        EXPECT_EQ(letters, "");
    }
}

class WrappedText : public test::Workbench {};

// Dear ImGui's draw lists end at 65,536 vertices, where the host's OpenGL is old.
TEST_F(WrappedText, NamesOfFourKilobytesNeedFewLetters) {
    const std::string name = std::string(4090, 'm') + ".png";
    texture().file = name;
    texture().source = SourceKind::File;
    for (const Tab tab : {Tab::Levels, Tab::Memory, Tab::File, Tab::Explain, Tab::History}) {
        session->window.wantedTab = tab;
        frames(3);
        for (const ImDrawList* list :
             std::span(&ImGui::GetDrawData()->CmdLists[0],
                       static_cast<std::size_t>(ImGui::GetDrawData()->CmdListsCount)))
            EXPECT_LT(list->VtxBuffer.Size, 30'000) << list->_OwnerName << rowOf(tab).label;
        expectSoundFrame();
    }
}

} // namespace
} // namespace texplorer::ui::wrapped_text_test
