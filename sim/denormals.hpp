// Numbers too small to be normal, which cost a processor a hundred times what others do.
#pragma once

#if defined(__SSE__)
#include <xmmintrin.h>
#endif

namespace waterlight {

/// While it lives, this thread takes such numbers for 0, where the processor can: ahead of every wave that spreads over
/// still water there is a ring of them.
class DenormalsAreZero {
  public:
    DenormalsAreZero(const DenormalsAreZero&) = delete;
    DenormalsAreZero& operator=(const DenormalsAreZero&) = delete;

#if defined(__SSE__)
    DenormalsAreZero() : before_(_mm_getcsr()) { _mm_setcsr(before_ | flush_results | flush_operands); }
    ~DenormalsAreZero() { _mm_setcsr(before_); }

  private:
    static constexpr unsigned flush_results = 0x8000, flush_operands = 0x0040;  // bits of MXCSR
    unsigned before_;
#else
    DenormalsAreZero() = default;
#endif
};

}  // namespace waterlight
