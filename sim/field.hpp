// A two-dimensional array of numbers, contiguous, x fastest, aligned for SIMD.
#pragma once

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <memory>
#include <new>
#include <span>
#include <type_traits>

namespace waterlight {

/// nx by ny values of T; row j starts at row(j). Movable, and copyable by an explicit call of clone().
template <class T>
class Field {
    static_assert(std::is_trivially_copyable_v<T>);

  public:
    Field() = default;
    /// All values zero.
    Field(int nx, int ny) : nx_(nx), ny_(ny), data_(allocate(size())) { fill(T(0)); }

    Field(Field&& other) noexcept { swap(other); }
    Field& operator=(Field&& other) noexcept {
        swap(other);
        return *this;
    }
    Field(const Field&) = delete;
    Field& operator=(const Field&) = delete;

    Field clone() const {
        Field copy;
        copy.nx_ = nx_;
        copy.ny_ = ny_;
        copy.data_ = allocate(size());
        std::copy_n(data(), size(), copy.data());
        return copy;
    }

    int nx() const { return nx_; }
    int ny() const { return ny_; }
    std::size_t size() const { return static_cast<std::size_t>(nx_) * static_cast<std::size_t>(ny_); }
    bool empty() const { return size() == 0; }

    T* data() { return data_.get(); }
    const T* data() const { return data_.get(); }
    T* row(int j) { return data_.get() + static_cast<std::ptrdiff_t>(j) * nx_; }
    const T* row(int j) const { return data_.get() + static_cast<std::ptrdiff_t>(j) * nx_; }
    std::span<T> values() { return {data(), size()}; }
    std::span<const T> values() const { return {data(), size()}; }

    T& operator()(int i, int j) {
        assert(i >= 0 && i < nx_ && j >= 0 && j < ny_);
        return row(j)[i];
    }
    const T& operator()(int i, int j) const {
        assert(i >= 0 && i < nx_ && j >= 0 && j < ny_);
        return row(j)[i];
    }

    void fill(T value) { std::fill_n(data(), size(), value); }

  private:
    static constexpr std::align_val_t alignment{64};
    struct Free {
        void operator()(T* p) const { ::operator delete[](p, alignment); }
    };
    using Storage = std::unique_ptr<T[], Free>;

    static Storage allocate(std::size_t count) {
        return Storage(static_cast<T*>(::operator new[](std::max<std::size_t>(count, 1) * sizeof(T), alignment)));
    }
    void swap(Field& other) noexcept {
        std::swap(nx_, other.nx_);
        std::swap(ny_, other.ny_);
        std::swap(data_, other.data_);
    }

    int nx_ = 0;
    int ny_ = 0;
    Storage data_;
};

}  // namespace waterlight
