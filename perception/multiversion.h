// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
//
// One source, several machines: a function marked HINDSIGHT_MULTIVERSION is compiled for plain x86-64 and for
// AVX2 machines (x86-64-v3), and the loader picks one. Both give the same bits: sums of floats keep the order
// in which they are written, and fused multiply-add is off. On other machines (ARM) the compiler's own
// baseline is vectorised.
#pragma once

// Sanitizers cannot run code before the loader has picked a version.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && !defined(HINDSIGHT_SANITIZED)
#define HINDSIGHT_MULTIVERSION __attribute__((target_clones("arch=x86-64-v3", "default")))
#else
#define HINDSIGHT_MULTIVERSION
#endif

/// For the helpers of such a function: they must be compiled into each of its versions.
#define HINDSIGHT_ALWAYS_INLINE inline __attribute__((always_inline))
