#pragma once

#include "app/gles/device.h"

#include <memory>

namespace texplorer::gles {

/// An object of a device, dropped with its last owner.
using Object = std::shared_ptr<const unsigned>;

/// Owns the object of this name. The device must outlive it.
[[nodiscard]] inline Object own(Device& device, unsigned name, void (Device::*drop)(unsigned)) {
    return {new unsigned(name), [&device, drop](const unsigned* at) {
                (device.*drop)(*at);
                delete at;
            }};
}

} // namespace texplorer::gles
