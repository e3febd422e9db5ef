// SPDX-License-Identifier: Apache-2.0
#define K 1
#ifdef K
#ifndef ONCE
#define ONCE
float inc_a;
#endif 
#endif
