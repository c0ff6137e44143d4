#pragma once

// Pillow as an oracle. The scripts get Debian's interpreter, which has python3-pil.

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <string>

namespace texplorer::test {

/// Runs a script of the tests folder ("fixtures/make_bmp.py") with one argument; it fails by its exit status,
/// and what it prints goes into the test's output.
[[nodiscard]] inline testing::AssertionResult runPython(const std::string& script,
                                                        const std::filesystem::path& argument) {
    const std::string command =
        std::string(TEXPLORER_PYTHON " '" TEXPLORER_TESTS_DIR "/") + script + "' '" + argument.string() + "'";
    const int status = std::system(command.c_str());
    if (status == 0)
        return testing::AssertionSuccess();
    return testing::AssertionFailure() << command << " ended with status " << status;
}

} // namespace texplorer::test
