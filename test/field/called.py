# SPDX-License-Identifier: BSD-3-Clause
"""What a command of the package answers: its exit status, standard output and standard error."""
import io
from contextlib import redirect_stderr, redirect_stdout


def called(main, *words):
    out, told = io.StringIO(), io.StringIO()
    with redirect_stdout(out), redirect_stderr(told):
        status = main(list(words))
    return status, out.getvalue(), told.getvalue()
