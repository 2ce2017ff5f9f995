// The state of a run as bytes. One function of each part says what its state is, for both ways.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

namespace waterlight {

/// Collects state, or gives it back in the same order. Values are copied bit by bit: they serve the same program on the
/// same kind of machine. Giving back throws WorldError where what is asked for is not what was collected there.
class StateArchive {
  public:
    /// Collects.
    StateArchive() = default;
    /// Gives back what an archive of these bytes() collected.
    explicit StateArchive(std::string collected) : parts_{std::move(collected)}, restores_(true) {}

    bool restores() const { return restores_; }

    template <class T>
    void value(T& value) {
        static_assert(std::is_trivially_copyable_v<T>);
        block(std::as_writable_bytes(std::span(&value, 1)));
    }
    /// As many as there are.
    template <class T>
    void values(std::span<T> values) {
        static_assert(std::is_trivially_copyable_v<T>);
        block(std::as_writable_bytes(values));
    }
    /// Its length is part of the state.
    template <class T>
    void list(std::vector<T>& values) {
        resize(values);
        this->values(std::span(values));
    }
    void text(std::string& text) {
        resize(text);
        values(std::span(text));
    }

    /// Throws WorldError where not all was given back.
    void require_end() const;

    /// What was collected, to be written one after the other. Large fields have a part of their own.
    const std::vector<std::string>& parts() const { return parts_; }
    std::size_t bytes() const;

  private:
    /// Its length, then itself.
    void block(std::span<std::byte> data);
    void collect(std::span<const std::byte> data);
    void give_back(std::span<std::byte> data);
    template <class Sequence>
    void resize(Sequence& sequence) {
        std::uint64_t count = sequence.size();
        value(count);
        if (restores_) sequence.resize(checked(count, sizeof(typename Sequence::value_type)));
    }
    /// The count of a sequence that can be there.
    std::size_t checked(std::uint64_t count, std::size_t size) const;

    std::vector<std::string> parts_;
    bool restores_ = false;
    std::size_t next_ = 0;  ///< where the next block begins in what is given back
};

}  // namespace waterlight
