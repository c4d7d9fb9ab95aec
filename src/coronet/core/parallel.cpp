// SPDX-License-Identifier: BSD-3-Clause
#include "coronet/core/parallel.hpp"

#include <omp.h>

namespace coronet {

void set_threads(int threads) {
    static int const standard = omp_get_max_threads();
    omp_set_num_threads(threads > 0 ? threads : standard);
}

void deal_blocks(std::size_t blocks) {
    constexpr std::size_t many = 64;
    if (blocks >= many) omp_set_schedule(omp_sched_static, 0);
    else omp_set_schedule(omp_sched_dynamic, 1);
}

int threads() { return omp_get_max_threads(); }

}  // namespace coronet
