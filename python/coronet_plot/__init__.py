# SPDX-License-Identifier: BSD-3-Clause
"""The figures of a run, drawn from what it left in its directory. `coronet plot DIR` calls this package."""
