// Makes the main thread the one that LLVM's OpenMP counts as its first, for as long as the program runs. Its end of a
// critical section looks at that thread's data whichever thread it is in (up to LLVM 21; llvm-project's pull request
// 169826), and falls where the first was a thread that is gone.
namespace {

[[maybe_unused]] const bool is_counted = [] {
    bool any = false;
#pragma omp parallel reduction(|| : any)
    any = true;
    return any;
}();

}  // namespace
