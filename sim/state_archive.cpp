#include "sim/state_archive.hpp"

#include <cassert>
#include <cstring>

#include "sim/error.hpp"

namespace waterlight {

namespace {

constexpr std::size_t large = std::size_t{1} << 16;

[[noreturn]] void throw_other_state() { throw WorldError("it holds the state of another kind of run"); }

}  // namespace

std::size_t StateArchive::bytes() const {
    std::size_t sum = 0;
    for (const std::string& part : parts_) sum += part.size();
    return sum;
}

void StateArchive::block(std::span<std::byte> data) {
    std::uint64_t size = data.size();
    if (!restores_) {
        collect(std::as_bytes(std::span(&size, 1)));
        collect(data);
        return;
    }
    give_back(std::as_writable_bytes(std::span(&size, 1)));
    if (size != data.size()) throw_other_state();
    give_back(data);
}

void StateArchive::collect(std::span<const std::byte> data) {
    // A large part is never grown, which would copy it.
    const bool fresh = parts_.empty() || data.size() >= large || parts_.back().size() >= large;
    if (fresh) parts_.emplace_back();
    parts_.back().append(reinterpret_cast<const char*>(data.data()), data.size());
}

void StateArchive::give_back(std::span<std::byte> data) {
    assert(parts_.size() == 1);
    const std::string& from = parts_.front();
    if (data.size() > from.size() - next_) throw_other_state();
    if (!data.empty()) std::memcpy(data.data(), from.data() + next_, data.size());
    next_ += data.size();
}

void StateArchive::require_end() const {
    assert(restores_);
    if (next_ != parts_.front().size()) throw_other_state();
}

std::size_t StateArchive::checked(std::uint64_t count, std::size_t size) const {
    if (count > (parts_.front().size() - next_) / size) throw_other_state();
    return count;
}

}  // namespace waterlight
