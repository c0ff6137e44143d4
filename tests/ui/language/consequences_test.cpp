// What the status bar says of the explained pixel and of the last edit, in every language: all that it can
// say is said, and nothing stays English.

#include "app/ui/model/consequence.h"
#include "tests/ui/language/said.h"
#include "tests/ui/workbench.h"
#include "texplorer/scene/params/params.h"

namespace texplorer::consequences_test {
namespace {

using namespace test;
using namespace ui;
using reference::Explanation;
using reference::FragmentOutcome;
using reference::UnitExplanation;

constexpr std::string_view source = "app/ui/model/consequence.cpp";

/// Of every filter, target, kind of footprint and number of levels.
void addUnits(Said& said) {
    said.add(consequenceOf(UnitExplanation())); // which has no level
    for (const EnumRow& target : EnumTable<Target>::rows)
        for (const EnumRow& minFilter : EnumTable<MinFilter>::rows)
            for (const EnumRow& magFilter : EnumTable<MagFilter>::rows)
                for (const int probes : {1, 8})
                    for (const double rho : {0.25, 4.0})
                        for (const float weight : {0.25F, 1.0F}) {
                            UnitExplanation unit;
                            unit.target = static_cast<Target>(target.value);
                            unit.sampler.minFilter = static_cast<MinFilter>(minFilter.value);
                            unit.sampler.magFilter = static_cast<MagFilter>(magFilter.value);
                            unit.sample.lod.rho = rho;
                            unit.sample.lod.magnified = rho < 1;
                            unit.sample.lod.probes = probes;
                            unit.sample.levels = {{1, weight}, {2, 1 - weight}};
                            said.add(consequenceOf(unit));
                        }
}

class Consequences : public Workbench, public testing::WithParamInterface<Language> {
protected:
    /// Of a fragment that passes or fails the tests in every way, and of no fragment at all.
    void addPixels(Said& said) {
        session->look.explaining.pixel = {layout.picture.width / 2, layout.picture.height / 2};
        frames(3);
        ASSERT_NE(session->look.explaining.answer, nullptr);
        Explanation explanation;
        addPixel(said, explanation);
        reference::FragmentExplanation& fragment = explanation.fragments.emplace_back();
        fragment.outcome = FragmentOutcome::Drawn;
        addPixel(said, explanation);
        fragment.units.emplace_back();
        addPixel(said, explanation);
        for (const EnumRow& function : EnumTable<CompareFunc>::rows) {
            fragment.alphaTest.function = fragment.depthTest.function =
                static_cast<CompareFunc>(function.value);
            for (const FragmentOutcome outcome :
                 {FragmentOutcome::FailedAlphaTest, FragmentOutcome::FailedDepthTest}) {
                fragment.outcome = outcome;
                addPixel(said, explanation);
            }
        }
    }

    /// Of the name of an edit of each parameter.
    void addStates(Said& said) const {
        Document document(defaultScene(), ImageSource{});
        said.add(stateOf(document));
        document.file = "/scenes/earth.json";
        said.add(stateOf(document));
        document.scene.view.distance += 1;
        said.add(stateOf(document));
        forEachParam(defaultScene(), [&](const std::string&, const ParamRow& row, const Value&) {
            document.scene.view.distance += 1;
            document.history.record(document.scene, row.label);
            said.add(stateOf(document));
        });
    }

private:
    void addPixel(Said& said, const Explanation& explanation) {
        reference::ProbeWorker::Answer answer = *session->look.explaining.answer;
        answer.explanation = explanation;
        session->look.explaining.answer =
            std::make_shared<const reference::ProbeWorker::Answer>(std::move(answer));
        said.add(consequenceOf(*session));
    }
};

TEST_P(Consequences, AreAllSaidInTheLanguage) {
    Said said;
    addUnits(said);
    addPixels(said);
    addStates(said);
    std::set<std::string, std::less<>> gaps;
    speak(GetParam(), &gaps);
    EXPECT_TRUE(said.unsaidOf(source).empty()) << said.unsaidOf(source);
    if (GetParam() != Language::English) {
        EXPECT_TRUE(said.english().empty()) << said.english();
    }
    for (const Sentence& each : said.sentences())
        EXPECT_EQ(tr(each) == each.english(), GetParam() == Language::English) << each;
    EXPECT_THAT(gaps, testing::IsEmpty());
}

INSTANTIATE_TEST_SUITE_P(All, Consequences,
                         testing::Values(Language::English, Language::Chinese, Language::Russian),
                         [](const auto& each) { return std::string(rowOf(each.param).name); });

} // namespace
} // namespace texplorer::consequences_test
