// SPDX-License-Identifier: BSD-3-Clause
#include "coronet/core/parallel.hpp"

#include <omp.h>

namespace coronet {

void set_threads(int threads) {
    static int const standard = omp_get_max_threads();
    omp_set_num_threads(threads > 0 ? threads : standard);
}

int threads() { return omp_get_max_threads(); }

}  // namespace coronet
