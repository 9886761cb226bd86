/// Memory for the numbers of GMP in builds with a fuzzing engine: the allocator of ASan makes each number
/// several times dearer than the arithmetic on it, and most numbers have one limb.
#pragma once

namespace flatdt::fuzz {

/// Makes GMP take blocks of up to 32 limbs from lists of free blocks, one for each size, and larger ones from
/// malloc. A free block and the limb after each block are poisoned, so that ASan still reports what
/// instrumented code reads there; a block freed twice aborts. What is given up: blocks are used again at
/// once, and GMP's own code was never instrumented. Blocks that GMP had before are taken over when they are
/// freed. To be called by the thread that runs the inputs.
void use_limb_pool();

}  // namespace flatdt::fuzz
