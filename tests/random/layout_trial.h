#pragma once

#include "tests/random/window_trial.h"

namespace texplorer::random {

/// One of all combinations of a window's size and scale, its views, columns and details. Fails like a test.
class LayoutTrial : public WindowTrial {
public:
    [[nodiscard]] static int count();

    LayoutTrial(unsigned seed, int number, Journal& journal);
    void run();

private:
    void expectFilledWindow() const;
    void expectNothingTooWide() const;
    void expectNoGap();

    int number_;
};

} // namespace texplorer::random
