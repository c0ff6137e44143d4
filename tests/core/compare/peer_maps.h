#pragma once

#include "tests/core/compare/metric_maps.h"
#include "tests/support/python.h"
#include "texplorer/codec/registry.h"
#include "texplorer/files/file_io.h"

#include <filesystem>
#include <string>

namespace texplorer::test {

/// Writes NAME.`extension`, the values of each pair of pictures that make_picture_pairs.py makes in the
/// folder, from the upper left, as floats. `checked` counts them.
inline void writeMaps(const std::filesystem::path& folder, const Criterion& criterion,
                      const std::string& extension, int& checked) {
    ASSERT_TRUE(runPython("fixtures/make_picture_pairs.py", folder));
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
        constexpr std::string_view end = "-expected.png";
        const std::string path = entry.path().string();
        if (!path.ends_with(end))
            continue;
        const std::string name = path.substr(0, path.size() - end.size());
        const Result<Bytes> expectedBytes = readFile(path);
        const Result<Bytes> actualBytes = readFile(name + "-actual.png");
        ASSERT_TRUE(expectedBytes && actualBytes);
        const Result<Image> expected = decodeImage(*expectedBytes);
        const Result<Image> actual = decodeImage(*actualBytes);
        ASSERT_TRUE(expected && actual) << name;
        const std::vector<float> values = valuesOf(*expected, *actual, criterion);
        ASSERT_TRUE(writeFileAtomically(name + "." + extension, std::as_bytes(std::span(values))));
        ++checked;
    }
}

} // namespace texplorer::test
