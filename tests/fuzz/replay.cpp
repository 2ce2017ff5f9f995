// Runs a target over seeds and damaged copies of them, without a fuzzer: replay COPIES PATH...
#include <algorithm>
#include <iterator>
#include <random>
#include <vector>

#include "tests/fuzz/reader.hpp"
#include "tests/support/damage.hpp"

namespace {

std::string bytes_of(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

std::vector<std::string> seeds_in(const std::filesystem::path& path) {
    if (!std::filesystem::is_directory(path)) return {bytes_of(path)};
    std::vector<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::directory_iterator(path))
        if (entry.is_regular_file()) files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    std::vector<std::string> seeds;
    for (const std::filesystem::path& file : files) seeds.push_back(bytes_of(file));
    return seeds;
}

void read(const std::string& bytes) {
    LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size());
}

}  // namespace

int main(int count, char** arguments) {
    if (count < 3) {
        std::fprintf(stderr, "usage: %s COPIES PATH...\n", arguments[0]);
        return 2;
    }
    std::vector<std::string> seeds;
    for (int i = 2; i < count; ++i)
        for (std::string& seed : seeds_in(arguments[i])) seeds.push_back(std::move(seed));
    if (seeds.empty()) {
        std::fprintf(stderr, "no seeds\n");
        return 1;
    }
    for (const std::string& seed : seeds) read(seed);
    std::mt19937 random(17);
    const int copies = std::atoi(arguments[1]);
    for (int i = 0; i < copies; ++i) read(waterlight::testing::damaged(seeds[random() % seeds.size()], seeds, random));
    std::printf("%zu seeds and %d damaged copies read\n", seeds.size(), copies);
}
