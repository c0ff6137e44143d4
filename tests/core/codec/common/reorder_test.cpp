#include "texplorer/base/bytes.h"
#include "texplorer/codec/common/reorder.h"

#include <gtest/gtest.h>

namespace texplorer::reorder_test {
namespace {

TEST(Reorder, AgreesWithItsScalarTwinForEveryLengthAndStaysInside) {
    for (const ByteOrder& order : {ByteOrder{2, 1, 0, 3}, {3, 2, 1, 0}, {0, 1, 2, 3}, {1, 1, 0, 2}}) {
        for (std::size_t count = 0; count < 50; ++count) {
            Bytes from(4 * count);
            for (std::size_t i = 0; i < from.size(); ++i)
                from[i] = static_cast<std::byte>(i * 37 + 11);
            for (const std::size_t components : {std::size_t{3}, std::size_t{4}}) {
                Bytes expected(components * count);
                reorderScalar(from.data(), expected.data(), count, order, components);
                for (std::size_t pixel = 0; pixel < count; ++pixel)
                    for (std::size_t c = 0; c < components; ++c)
                        ASSERT_EQ(expected[components * pixel + c], from[4 * pixel + order[c]]);

                Bytes to(components * count + 16, std::byte{0x5A});
                (components == 3 ? reorderFourToThree : reorderFourToFour)(from.data(), to.data(), count,
                                                                           order);
                EXPECT_TRUE(std::equal(expected.begin(), expected.end(), to.begin())) << count << " pixels";
                for (std::size_t i = expected.size(); i < to.size(); ++i)
                    ASSERT_EQ(to[i], std::byte{0x5A}) << "written after the end of " << count << " pixels";
            }
        }
    }
}

} // namespace
} // namespace texplorer::reorder_test
