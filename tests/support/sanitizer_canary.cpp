// Faults that a sanitizer must see, one by its name; and "order", which is none.
#include <climits>
#include <cstdio>
#include <string>
#include <vector>

namespace {

constexpr int count = 100000;

int read_beyond_the_end(int by) {
    const std::vector<int> values(4);
    return *(values.data() + 3 + by);
}

void forget_memory() {
    volatile int* lost = new int[count];
    lost[0] = 1;
    lost = nullptr;
}

int overflow(int by) {
    volatile int most = INT_MAX;
    return most + by;
}

/// Threads of OpenMP add to one number without regard for each other.
int add_in_a_race() {
    int sum = 0;
#pragma omp parallel for shared(sum) num_threads(4)
    for (int i = 0; i < count; ++i) sum += i;
    return sum;
}

/// The threads of the second loop read what others wrote in the first; the end of a loop and a reduction keep them
/// apart.
int add_in_order() {
    std::vector<int> values(count);
    int sum = 0;
#pragma omp parallel num_threads(4)
    {
#pragma omp for
        for (int i = 0; i < count; ++i) values[static_cast<std::size_t>(i)] = i % 7;
#pragma omp for reduction(+ : sum)
        for (int i = 0; i < count; ++i) sum += values[static_cast<std::size_t>(count - 1 - i)];
    }
    return sum;
}

}  // namespace

int main(int argc, char** argv) {
    const std::string fault = argc > 1 ? argv[1] : "";
    int result = 0;
    if (fault == "beyond_the_end") result = read_beyond_the_end(argc - 1);
    if (fault == "leak") forget_memory();
    if (fault == "overflow") result = overflow(argc - 1);
    if (fault == "race") result = add_in_a_race();
    if (fault == "order") result = add_in_order();
    std::printf("%d\n", result);
    return 0;
}
