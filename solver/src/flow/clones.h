// Instruction sets.
#pragma once

// One version of each loop per instruction set, chosen when the program starts.  Without
// contraction of products (the project compiles with -ffp-contract=off) they agree
// bitwise.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && \
    !defined(__SANITIZE_ADDRESS__)
#define PORECLOG_CLONES \
  __attribute__((target_clones("arch=x86-64-v4", "arch=x86-64-v3", "default")))
#else
#define PORECLOG_CLONES
#endif
