#pragma once

#include "tests/ui/workbench.h"

#include <fmt/core.h>

namespace texplorer::test {

/// The window with a figure in front.
class FigureBench : public Workbench {
protected:
    FigureBench() = default;
    explicit FigureBench(ui::Figure figure) { show(figure); }

    void show(ui::Figure figure) {
        session->window.wantedTab = ui::Tab::Figures;
        session->window.figure = figure;
        frames(4);
    }
    void expectAll(std::initializer_list<const char*> items) const {
        for (const char* each : items)
            EXPECT_TRUE(has(each)) << each;
    }
    [[nodiscard]] ui::FiguresTabState& figures() { return states.details.figures; }
    [[nodiscard]] std::size_t steps() const { return session->document.history.position(); }
};

} // namespace texplorer::test
