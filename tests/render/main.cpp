#include "tests/support/render_fixture.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <span>
#include <string_view>

/// --renderer=shader runs the tests with the shader renderer.
int main(int argc, char** argv) {
    testing::InitGoogleMock(&argc, argv);
    const auto given = std::span(argv, static_cast<std::size_t>(argc));
    if (std::ranges::find(given, std::string_view("--renderer=shader")) != given.end())
        texplorer::test::testedRenderer() = texplorer::RendererKind::Shader;
    return RUN_ALL_TESTS();
}
