#include "core/reference/kernel/headers.h"

#define TEXPLORER_LANES 4

namespace texplorer::reference {
namespace {
namespace four {

#include "core/reference/kernel/lanes_text.h"
#include "core/reference/kernel/sample_text.h"
#include "core/reference/kernel/shade_text.h"

} // namespace four
} // namespace

const Kernel* fourLanes() {
    return &four::kernel;
}

} // namespace texplorer::reference
