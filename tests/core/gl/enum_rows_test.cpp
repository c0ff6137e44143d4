// Walks every vocabulary table: names and numbers are unique, every text is there, lookups round-trip.

#include "texplorer/gl/environment.h"
#include "texplorer/gl/error.h"
#include "texplorer/gl/fragment.h"
#include "texplorer/gl/sampling.h"
#include "texplorer/gl/transfer.h"
#include "texplorer/report/state.h"
#include "texplorer/scene/scene.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace texplorer::enum_rows_test {
namespace {

struct Table {
    const char* name;
    std::span<const EnumRow> rows;
};

/// Letters rather than bytes: some labels have a ².
auto letters(std::string_view utf8) {
    return std::ranges::count_if(utf8,
                                 [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; });
}

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
        EXPECT_LE(letters(row.label), 24) << row.name << ": a label must fit its control";
        EXPECT_THAT(std::string(row.help), testing::EndsWith(".")) << row.name;
        const bool isGl =
            row.name.starts_with("GL_") || row.name.ends_with("Mipmap") || row.name.ends_with("Mipmaps");
        const bool isMistake = // an internal format in no version
            GetParam().rows.data() == EnumTable<InternalFormat>::rows.data() &&
            isRefused(static_cast<InternalFormat>(row.value));
        EXPECT_EQ(isGl && !isMistake, !row.since.empty())
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
        Table{"CubeFace", EnumTable<CubeFace>::rows},
        Table{"TransferFormat", EnumTable<TransferFormat>::rows},
        Table{"TransferType", EnumTable<TransferType>::rows}, Table{"EnvMode", EnumTable<EnvMode>::rows},
        Table{"BaseFormat", EnumTable<BaseFormat>::rows}, Table{"CombineRgb", EnumTable<CombineRgb>::rows},
        Table{"CombineAlpha", EnumTable<CombineAlpha>::rows},
        Table{"CombineSource", EnumTable<CombineSource>::rows},
        Table{"OperandRgb", EnumTable<OperandRgb>::rows},
        Table{"OperandAlpha", EnumTable<OperandAlpha>::rows},
        Table{"CombineScale", EnumTable<CombineScale>::rows},
        Table{"TexGenMode", EnumTable<TexGenMode>::rows}, Table{"ShadeModel", EnumTable<ShadeModel>::rows},
        Table{"ColorControl", EnumTable<ColorControl>::rows},
        Table{"CompareFunc", EnumTable<CompareFunc>::rows},
        Table{"BlendFactor", EnumTable<BlendFactor>::rows}, Table{"GlError", EnumTable<GlError>::rows},
        Table{"HintMode", EnumTable<HintMode>::rows}, Table{"Pattern", EnumTable<Pattern>::rows},
        Table{"MipPolicy", EnumTable<MipPolicy>::rows}, Table{"MipFilter", EnumTable<MipFilter>::rows},
        Table{"NpotPolicy", EnumTable<NpotPolicy>::rows}, Table{"Oversize", EnumTable<Oversize>::rows},
        Table{"Transparency", EnumTable<Transparency>::rows}, Table{"FlipMode", EnumTable<FlipMode>::rows},
        Table{"Compression", EnumTable<Compression>::rows},
        Table{"CompressedFormat", EnumTable<CompressedFormat>::rows},
        Table{"BlockFormat", EnumTable<BlockFormat>::rows}, Table{"Shape", EnumTable<Shape>::rows},
        Table{"Projection", EnumTable<Projection>::rows}, Table{"SourceKind", EnumTable<SourceKind>::rows},
        Table{"MatrixOp", EnumTable<MatrixOp>::rows}, Table{"State", EnumTable<report::State>::rows},
        Table{"Tone", EnumTable<report::Tone>::rows}),
    [](const auto& test) { return std::string(test.param.name); });

} // namespace
} // namespace texplorer::enum_rows_test
