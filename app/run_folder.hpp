// The folder of a run: it belongs to one run at a time, and keeps no leftovers of others.
#pragma once

#include <filesystem>
#include <set>

namespace waterlight {

class RunFolder {
  public:
    /// Makes the folder where it is missing, and holds it until the end: two runs at once would mix their files. Then
    /// removes what a run that was killed left unfinished. Throws WorldError where it cannot be made or written to, or
    /// where another run holds it, naming that.
    explicit RunFolder(std::filesystem::path path);
    ~RunFolder();
    RunFolder(const RunFolder&) = delete;
    RunFolder& operator=(const RunFolder&) = delete;

    const std::filesystem::path& path() const { return path_; }
    /// Throws WorldError where the folder is no longer the one that was made: it was moved or removed, and writing
    /// would begin another one with the later part of the files. From any thread.
    void require_present() const;
    /// Removes files under names of ours but for `written`, which an earlier, longer run left.
    void remove_stale(const std::set<std::filesystem::path>& written) const;

  private:
    void take();
    bool is_held() const;
    void remove_unfinished() const;

    std::filesystem::path path_;
    std::filesystem::path lock_;
    int descriptor_ = -1;
};

}  // namespace waterlight
