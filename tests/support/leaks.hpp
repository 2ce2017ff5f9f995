// For every test program that opens a Vulkan device.
#pragma once

#ifdef __SANITIZE_ADDRESS__
// The validation layer and the driver leak memory of their own.
extern "C" [[gnu::used]] inline const char* __lsan_default_suppressions() {
    return "leak:libVkLayer_khronos_validation\nleak:libvulkan_lvp\n";
}
#endif
