// SPDX-License-Identifier: Apache-2.0
#include "inner.fxh"
M(M(M(1)))
//--
#define M(a) float f##a = a;
#include "inner.fxh"
