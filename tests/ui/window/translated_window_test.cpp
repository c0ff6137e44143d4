// Menus and dialogs in another language: they have the same places for tests, and room for longer words.

#include "app/ui/files/asking.h"
#include "app/ui/language/translate.h"
#include "tests/ui/edits.h"
#include "tests/ui/workbench.h"

namespace texplorer::translated_window_test {
namespace {

using namespace ui;

constexpr std::string_view longSave = "Сохранить все изменения сцены";

class TranslatedWindow : public test::Workbench {
protected:
    TranslatedWindow() {
        const std::array files{CatalogueFile{"ru/test.po", R"(
msgid "Save"
msgstr "Сохранить все изменения сцены"

msgid "Edit"
msgstr "Правка"

msgid "Undo {0}"
msgstr "Отменить: {0}"

msgid "Wrap s"
msgstr "Повтор s"

msgid "Untitled"
msgstr "Без имени"

)"}};
        catalogue_ = Catalogue::parse(Language::Russian, files).value();
        useCatalogue(&catalogue_);
        texture().wrapS = Wrap::ClampToBorder;
        recordEdit(*session, "Wrap s");
        sealEdit(*session);
        frames(3);
    }
    ~TranslatedWindow() override { useCatalogue(nullptr); }

private:
    Catalogue catalogue_;
};

TEST_F(TranslatedWindow, MenusWorkAsInEnglish) {
    EXPECT_EQ(session->document.history.undoName(), "Wrap s") << "the document stays English";
    const Wrap before = defaultScene().textures.front().wrapS;
    click("menu:Edit");
    click("menu:Undo Wrap s");
    EXPECT_EQ(texture().wrapS, before);
}

TEST_F(TranslatedWindow, AButtonIsAsWideAsItsWords) {
    askNewScene(*session);
    frames(3);
    ASSERT_TRUE(has("discard:save"));
    const WidgetPlaces::Item item = places.items.find("discard:save")->second;
    EXPECT_GE(item.right - item.left, ImGui::CalcTextSize(longSave.data()).x);
    click("discard:cancel");
    EXPECT_EQ(session->asking.dialog, Dialog::None);
}

TEST_F(TranslatedWindow, TheTitleOfTheWindowIsTranslatedToo) {
    EXPECT_EQ(windowTitle(session->document), "Без имени • Texplorer");
}

} // namespace
} // namespace texplorer::translated_window_test
