#include "texplorer/base/background_thread.h"

#include <sys/resource.h>
#include <sys/syscall.h>
#include <unistd.h>

namespace texplorer {

void giveWay() {
    constexpr int niceness = 10;
    // Linux has it for each thread (setpriority(2), "C library/kernel differences"); new ones inherit it.
    const auto thread = static_cast<id_t>(::syscall(SYS_gettid));
    if (::getpriority(PRIO_PROCESS, thread) < niceness)
        (void)::setpriority(PRIO_PROCESS, thread, niceness);
}

} // namespace texplorer
