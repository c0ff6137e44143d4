#include "texplorer/base/background_thread.h"

namespace texplorer {

void giveWay() {}

} // namespace texplorer
