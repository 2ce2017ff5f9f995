// Snapshots that come back when nobody holds them any more, with their buffers.
#pragma once

#include <memory>
#include <mutex>
#include <vector>

#include "app/view/snapshot.hpp"

namespace waterlight {

/// May be used and outlived from any thread: snapshots keep what they return to.
class SnapshotPool {
  public:
    SnapshotPool() : free_(std::make_shared<Free>()) {}

    /// One to fill: a new one, or one whose last holder let it go.
    std::shared_ptr<Snapshot> take();

  private:
    struct Free {
        std::mutex mutex;
        std::vector<std::unique_ptr<Snapshot>> snapshots;
    };
    std::shared_ptr<Free> free_;
};

}  // namespace waterlight
