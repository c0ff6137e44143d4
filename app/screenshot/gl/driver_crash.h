#pragma once

namespace texplorer::screenshot {

/// From here on a crash of this process ends it with a sentence and the status of a failure instead of a
/// signal. Not where a sanitizer looks after crashes.
void sayCrashes();

/// From here on it is the driver that is named: its code has been loaded.
void driverIsLoaded();

} // namespace texplorer::screenshot
