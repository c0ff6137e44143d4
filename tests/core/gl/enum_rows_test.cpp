// Walks every vocabulary table: names and numbers are unique, every text is there, lookups round-trip.

#include "core/gl/environment.h"
#include "core/gl/error.h"
#include "core/gl/fragment.h"
#include "core/gl/sampling.h"
#include "core/scene/scene.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

namespace texplorer {
namespace {

struct Table {
    const char* name;
    std::span<const EnumRow> rows;
};

class EnumRows : public testing::TestWithParam<Table> {};

TEST_P(EnumRows, NumbersAndNamesAreUniqueAndFindTheirRow) {
    std::set<std::uint32_t> numbers;
    std::set<std::string_view> names;
    for (const EnumRow& row : GetParam().rows) {
        EXPECT_TRUE(numbers.insert(row.value).second) << row.name;
        EXPECT_TRUE(names.insert(row.name).second) << row.name;
        EXPECT_EQ(findRow(GetParam().rows, row.value), &row);
        EXPECT_EQ(findRow(GetParam().rows, row.name), &row);
    }
}

TEST_P(EnumRows, EveryTextIsThereAndEveryHelpIsASentence) {
    for (const EnumRow& row : GetParam().rows) {
        EXPECT_FALSE(row.name.empty());
        EXPECT_FALSE(row.label.empty()) << row.name;
        EXPECT_LE(row.label.size(), 24U) << row.name << ": a label must fit its control";
        EXPECT_THAT(std::string(row.help), testing::EndsWith(".")) << row.name;
        EXPECT_EQ(row.name.starts_with("GL_"), !row.since.empty())
            << row.name << ": GL's names say since which version GL has them, ours have none";
    }
}

TEST_P(EnumRows, UnknownNamesAndNumbersFindNothing) {
    EXPECT_EQ(findRow(GetParam().rows, "GL_NONSENSE"), nullptr);
    EXPECT_EQ(findRow(GetParam().rows, 0xFFFFFFFFU), nullptr);
}

INSTANTIATE_TEST_SUITE_P(
    All, EnumRows,
    testing::Values(
        Table{"MagFilter", EnumTable<MagFilter>::rows}, Table{"MinFilter", EnumTable<MinFilter>::rows},
        Table{"Wrap", EnumTable<Wrap>::rows}, Table{"Target", EnumTable<Target>::rows},
        Table{"EnvMode", EnumTable<EnvMode>::rows}, Table{"BaseFormat", EnumTable<BaseFormat>::rows},
        Table{"ShadeModel", EnumTable<ShadeModel>::rows},
        Table{"ColorControl", EnumTable<ColorControl>::rows},
        Table{"CompareFunc", EnumTable<CompareFunc>::rows},
        Table{"BlendFactor", EnumTable<BlendFactor>::rows}, Table{"GlError", EnumTable<GlError>::rows},
        Table{"Pattern", EnumTable<Pattern>::rows}, Table{"MipPolicy", EnumTable<MipPolicy>::rows},
        Table{"Shape", EnumTable<Shape>::rows}, Table{"Projection", EnumTable<Projection>::rows},
        Table{"SourceKind", EnumTable<SourceKind>::rows}, Table{"MatrixOp", EnumTable<MatrixOp>::rows}),
    [](const auto& test) { return std::string(test.param.name); });

} // namespace
} // namespace texplorer
