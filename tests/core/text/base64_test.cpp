#include "texplorer/files/file_io.h"
#include "texplorer/text/base64.h"

#include <gtest/gtest.h>

namespace texplorer::base64_test {
namespace {

// RFC 4648, section 10.
TEST(Base64, GivesTheVectorsOfItsSpecification) {
    struct Row {
        std::string_view bytes;
        std::string_view text;
    };
    for (const auto& [bytes, text] :
         {Row{"", ""}, Row{"f", "Zg=="}, Row{"fo", "Zm8="}, Row{"foo", "Zm9v"}, Row{"foob", "Zm9vYg=="},
          Row{"fooba", "Zm9vYmE="}, Row{"foobar", "Zm9vYmFy"}, Row{"\xFB\xFF\xFE", "+//+"}})
        EXPECT_EQ(base64(viewBytes(bytes)), text);
}

} // namespace
} // namespace texplorer::base64_test
