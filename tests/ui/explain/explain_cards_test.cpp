#include "app/ui/explain/explain_cards.h"
#include "texplorer/reference/probe.h"
#include "texplorer/scene/scene.h"
#include "texplorer/texture/image_source.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

namespace texplorer::ui::explain_cards_test {
namespace {

using namespace reference;
using testing::ElementsAre;

std::vector<std::string> namesOf(const std::vector<Card>& cards) {
    std::vector<std::string> names;
    for (const Card& card : cards)
        names.push_back(card.name);
    return names;
}

std::vector<std::string> textsOf(const Card& card) {
    std::vector<std::string> texts;
    for (const CardLine& line : card.lines)
        texts.push_back(line.text);
    return texts;
}

/// A fragment in which every number is chosen.
FragmentExplanation madeUp() {
    FragmentExplanation fragment;
    fragment.vertices.resize(3);
    constexpr std::array weights{0.5F, 0.3F, 0.2F};
    for (std::size_t i = 0; i < 3; ++i) {
        fragment.vertices[i].vertex = static_cast<std::uint32_t>(10 + i);
        fragment.vertices[i].weight = weights.at(i);
        fragment.vertices[i].lighting.emplace();
    }
    UnitExplanation& unit = fragment.units.emplace_back();
    unit.coords = {1.25F, -0.5F, 0};
    unit.vertices.resize(3);
    unit.sample.lod.rho = 6;
    unit.sample.lod.lambda = 2.75F;
    unit.sample.lod.magnified = false;
    unit.sample.levels = {{2, 0.25F}, {3, 0.75F}};
    unit.sample.taps = {{2, {1, 1, 0}, 0.125F, {1, 0, 0, 1}},
                        {2, {2, 1, 0}, 0.125F, {1, 0, 0, 1}},
                        {3, {0, 0, 0}, 0.75F, {0, 0, 1, 1}}};
    unit.sample.color = {0.25F, 0, 0.75F, 1};
    unit.mode = EnvMode::Replace;
    unit.result = {0.25F, 0, 0.75F, 1};
    fragment.depthTest.enabled = true;
    fragment.after = {106, 0, 149, 255};
    return fragment;
}

std::vector<Card> cardsOf(const FragmentExplanation& fragment) {
    return ui::cardsOf(fragment, stepsOf(fragment));
}

TEST(ExplainCards, AreOnesPathThroughOpenGl) {
    EXPECT_THAT(namesOf(cardsOf(madeUp())), ElementsAre("Vertices", "Coordinates", "LOD", "Texels", "Filter",
                                                        "Environment", "Tests", "Pixel"));
}

TEST(ExplainCards, SayWhatOneWantsToKnowFirst) {
    const std::vector<Card> cards = cardsOf(madeUp());
    ASSERT_EQ(cards.size(), 8U);
    EXPECT_THAT(textsOf(cards[0]), ElementsAre("10: 50 %", "11: 30 %", "12: 20 %"));
    EXPECT_THAT(textsOf(cards[1]), ElementsAre("s 1.25", "t -0.5"));
    EXPECT_THAT(textsOf(cards[2]), ElementsAre("λ 2.75", "minified 6×"));
    EXPECT_THAT(textsOf(cards[3]), ElementsAre("3 texels", "levels 2, 3"));
    EXPECT_THAT(textsOf(cards[4]), ElementsAre("level 2: 25 %", "level 3: 75 %", "0.25 0.00 0.75"));
    EXPECT_THAT(textsOf(cards[5]), ElementsAre("Replace", "0.25 0.00 0.75", "alpha 1.00"));
    EXPECT_THAT(textsOf(cards[6]), ElementsAre("alpha: off", "depth: passed", "blending: off"));
    EXPECT_THAT(textsOf(cards[7]), ElementsAre("106 0 149", "alpha 255"));
    EXPECT_EQ(cards[1].lines[0].ink, Ink::S);
    EXPECT_EQ(cards[1].lines[1].ink, Ink::T);
}

TEST(ExplainCards, SayByHowMuchIsMagnified) {
    FragmentExplanation fragment = madeUp();
    fragment.units[0].sample.lod.rho = 0.125;
    fragment.units[0].sample.lod.lambda = -3;
    fragment.units[0].sample.lod.magnified = true;
    fragment.units[0].sample.levels = {{0, 1}};
    fragment.units[0].sample.taps = {{0, {1, 1, 0}, 1, {1, 0, 0, 1}, true}};
    fragment.units[0].sampler.magFilter = MagFilter::Nearest;
    const std::vector<Card> cards = cardsOf(fragment);
    EXPECT_THAT(textsOf(cards[2]), ElementsAre("λ -3", "magnified 8×"));
    EXPECT_THAT(textsOf(cards[3]), ElementsAre("1 texel", "level 0", "with border"));
    EXPECT_EQ(cards[4].lines[0].text, std::string(rowOf(MagFilter::Nearest).label));
    fragment.units[0].sample.lod.rho = 0;
    EXPECT_THAT(textsOf(cardsOf(fragment)[2]), ElementsAre("λ -3", "magnified"));
}

TEST(ExplainCards, OfAFragmentThatFailedEndWithTheTests) {
    FragmentExplanation fragment = madeUp();
    fragment.alphaTest.enabled = true;
    fragment.alphaTest.passed = false;
    fragment.outcome = FragmentOutcome::FailedAlphaTest;
    const std::vector<Card> cards = cardsOf(fragment);
    EXPECT_EQ(cards.back().name, "Tests");
    EXPECT_EQ(cards.back().lines[0], (CardLine{"alpha: failed", Ink::Bad}));
}

TEST(ExplainCards, NameTheUnitWhereThereAreSeveral) {
    FragmentExplanation fragment = madeUp();
    fragment.units.push_back(fragment.units[0]);
    fragment.units[1].unit = 1;
    fragment.idle.push_back({2, "Nothing is bound to it."});
    EXPECT_THAT(namesOf(cardsOf(fragment)),
                ElementsAre("Vertices", "Coordinates, unit 0", "LOD, unit 0", "Texels, unit 0",
                            "Filter, unit 0", "Environment, unit 0", "Coordinates, unit 1", "LOD, unit 1",
                            "Texels, unit 1", "Filter, unit 1", "Environment, unit 1",
                            "Without effect, unit 2", "Tests", "Pixel"));
}

TEST(ExplainCards, HaveEveryStepBehindOneOfThem) {
    Scene scene = defaultScene();
    scene.light.colorControl = ColorControl::SeparateSpecular;
    scene.passes[0].fog.enabled = true;
    const auto explanation = probe({scene, ImageSource{}, 0, 200, 150}, {60, 75});
    ASSERT_TRUE(explanation) << describe(explanation.error());
    ASSERT_NE(explanation->seen(), nullptr);
    const FragmentSteps steps = stepsOf(*explanation->seen());
    std::vector<std::size_t> found;
    for (const Card& card : ui::cardsOf(*explanation->seen(), steps)) {
        std::ranges::copy(card.steps, std::back_inserter(found));
        EXPECT_LE(card.lines.size(), 3U) << card.name;
    }
    ASSERT_EQ(found.size(), steps.steps.size());
    for (std::size_t i = 0; i < found.size(); ++i)
        EXPECT_EQ(found[i], i);
}

} // namespace
} // namespace texplorer::ui::explain_cards_test
