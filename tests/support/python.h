#pragma once

// Pillow as an oracle. The scripts get Debian's interpreter, which has python3-pil.

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

namespace texplorer::test {

/// Runs a script of the tests folder ("fixtures/make_bmp.py") with one argument; it fails by its exit status,
/// and what it prints goes into the test's output.
[[nodiscard]] testing::AssertionResult runPython(const std::string& script,
                                                 const std::filesystem::path& argument);

} // namespace texplorer::test
