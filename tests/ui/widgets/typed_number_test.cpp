#include "app/ui/widgets/keys.h"
#include "app/ui/widgets/typed_number.h"
#include "tests/ui/workbench.h"

#include <limits>

namespace texplorer::ui::typed_number_test {
namespace {

using namespace test;

TEST(ReadNumber, ReadsThousandsAndDecimals) {
    for (const auto& [text, number] : std::initializer_list<std::pair<const char*, float>>{
             {"1.5", 1.5F},
             {"1,5", 1.5F},
             {"-0,25", -0.25F},
             {"+3", 3},
             {"1,234", 1.234F},
             {"1,234.5", 1234.5F},
             {"1.234,5", 1234.5F},
             {"1,234,567", 1234567},
             {"-1.234.567,5", -1234567.5F},
             {".5", 0.5F},
             {"2e3", 2000},
             {"1,234.5e1", 12345},
             {"1e-999", 0},
             {"-1e999", -std::numeric_limits<float>::infinity()}})
        EXPECT_EQ(readNumber(text), number) << text;
}

TEST(ReadNumber, RefusesWhatCanBeReadInNoWayOrInSeveral) {
    for (const char* text :
         {"", "-", ".", "1,23.5", "1,2,3", "1.234.5", "1,234.567,8", "1.5,000.5", "1 2", "e3"})
        EXPECT_EQ(readNumber(text), std::nullopt) << text;
}

class TypedNumber : public Workbench {
protected:
    void typeOver(std::string_view name, std::string_view text) {
        doubleClickAt(place(name));
        key('A', {ctrl});
        type(text);
    }
};

TEST_F(TypedNumber, HasACommaBetweenThousands) {
    unit().matrix = {{.op = MatrixOp::Translate, .amount = {5, 0, 0}}};
    open("Texture matrix");
    const std::string_view amount = "passes[0].units[0].matrix[0].amount[0]";
    scrollTo(amount);
    typeOver(amount, "0,5");
    key(key::enter);
    EXPECT_EQ(unit().matrix[0].amount.x, 0.5F);
    typeOver(amount, "0,123.5");
    key(key::enter);
    EXPECT_EQ(unit().matrix[0].amount.x, 123.5F);
    typeOver(amount, "1,234.5"); // the range ends at 1000
    key(key::enter);
    EXPECT_EQ(unit().matrix[0].amount.x, 1000);
    typeOver(amount, "1,23.5"); // no number: as it was
    key(key::enter);
    EXPECT_EQ(unit().matrix[0].amount.x, 1000);
    typeOver(amount, "7");
    key(key::escape);
    EXPECT_EQ(unit().matrix[0].amount.x, 1000);
}

TEST_F(TypedNumber, OfACountHasACommaBetweenThousands) {
    texture().maxLevel = 1000;
    states.parameters.tab = ParameterTab::Texture;
    frames(2);
    scrollTo("textures[0].maxLevel");
    typeOver("textures[0].maxLevel", "0,012.0");
    key(key::enter);
    EXPECT_EQ(texture().maxLevel, 12);
}

} // namespace
} // namespace texplorer::ui::typed_number_test
