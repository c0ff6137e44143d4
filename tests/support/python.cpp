#include "tests/support/python.h"

#include <cstdlib>

namespace texplorer::test {

testing::AssertionResult runPython(const std::string& script, const std::filesystem::path& argument) {
    const std::string command =
        std::string(TEXPLORER_PYTHON " '" TEXPLORER_TESTS_DIR "/") + script + "' '" + argument.string() + "'";
    const int status = std::system(command.c_str());
    if (status == 0)
        return testing::AssertionSuccess();
    return testing::AssertionFailure() << command << " ended with status " << status;
}

} // namespace texplorer::test
