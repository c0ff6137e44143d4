#include "app/ui/state/inspected_file.h"

#include <gtest/gtest.h>

namespace texplorer::ui::inspected_file_test {
namespace {

Field field(std::size_t offset, std::size_t size, int depth = 1) {
    Field made;
    made.offset = offset;
    made.size = size;
    made.depth = depth;
    return made;
}

/// Which field each of the first ten bytes belongs to; '.' none.
std::string owners(std::vector<Field> fields) {
    Anatomy anatomy;
    anatomy.fields = std::move(fields);
    const FieldMap map(anatomy);
    std::string text;
    for (std::size_t i = 0; i < 10; ++i) {
        const auto owner = map.at(i);
        text += owner ? static_cast<char>('0' + *owner) : '.';
    }
    return text;
}

struct Row {
    const char* name;
    std::vector<Field> fields;
    const char* owners;
};

TEST(FieldOfByte, IsTheSmallestThatCoversIt) {
    for (const Row& row :
         {Row{"None", {}, ".........."}, Row{"One", {field(2, 3)}, "..000....."},
          Row{"SideBySide", {field(0, 2), field(2, 2)}, "0011......"},
          Row{"InASection", {field(0, 8, 0), field(2, 2), field(6, 2)}, "00110022.."},
          Row{"TwoSectionsDeep", {field(0, 9, 0), field(1, 6), field(2, 1, 2)}, "012111100."},
          Row{"ReachesBehindTheSection", {field(0, 4, 0), field(3, 3)}, "000111...."},
          Row{"EmptyField", {field(3, 0), field(2, 4)}, "..1111...."},
          Row{"SameBytesTwice", {field(1, 2), field(1, 2)}, ".11......."},
          Row{"WithoutEnd", {field(4, SIZE_MAX)}, "....000000"}})
        EXPECT_EQ(owners(row.fields), row.owners) << row.name;
}

} // namespace
} // namespace texplorer::ui::inspected_file_test
