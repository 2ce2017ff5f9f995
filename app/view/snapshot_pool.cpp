#include "app/view/snapshot_pool.hpp"

namespace waterlight {

std::shared_ptr<Snapshot> SnapshotPool::take() {
    std::unique_ptr<Snapshot> snapshot;
    {
        const std::scoped_lock lock(free_->mutex);
        if (!free_->snapshots.empty()) {
            snapshot = std::move(free_->snapshots.back());
            free_->snapshots.pop_back();
        }
    }
    if (!snapshot) snapshot = std::make_unique<Snapshot>();
    return {snapshot.release(), [free = free_](Snapshot* returned) {
                std::unique_ptr<Snapshot> owned(returned);
                const std::scoped_lock lock(free->mutex);
                free->snapshots.push_back(std::move(owned));
            }};
}

}  // namespace waterlight
