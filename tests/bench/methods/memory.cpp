#include "tests/bench/methods/memory.hpp"

#include <malloc.h>

#include <atomic>
#include <cstdlib>
#include <new>

namespace {

std::atomic<std::int64_t> held{0}, most{0};

void* counted(void* p) {
    if (p == nullptr) throw std::bad_alloc();
    const std::int64_t now = held += static_cast<std::int64_t>(malloc_usable_size(p));
    std::int64_t before = most;
    while (now > before && !most.compare_exchange_weak(before, now)) {
    }
    return p;
}

void uncounted(void* p) {
    if (p == nullptr) return;
    held -= static_cast<std::int64_t>(malloc_usable_size(p));
    std::free(p);
}

}  // namespace

void* operator new(std::size_t size) { return counted(std::malloc(size)); }
void* operator new(std::size_t size, std::align_val_t align) {
    const auto a = static_cast<std::size_t>(align);
    return counted(std::aligned_alloc(a, (size + a - 1) / a * a));
}
void operator delete(void* p) noexcept { uncounted(p); }
void operator delete(void* p, std::size_t) noexcept { uncounted(p); }
void operator delete(void* p, std::align_val_t) noexcept { uncounted(p); }
void operator delete(void* p, std::size_t, std::align_val_t) noexcept { uncounted(p); }

namespace waterlight::methods {

std::int64_t peak_bytes(const std::function<void()>& work) {
    const std::int64_t before = held;
    most = before;
    work();
    return most - before;
}

}  // namespace waterlight::methods
