# Runs a program as a hub does, and gives its log with what became of it as the last line.
import fake_hub
from fake_hub import LARGEST, log, state


unfinished = []


def show(*values, sep=" ", end="\n"):
    for value in values:
        if isinstance(value, int) and not -LARGEST - 1 <= value <= LARGEST:
            raise OverflowError("small int overflow")
    unfinished.append(sep.join(str(value) for value in values) + end)
    if end.endswith("\n"):
        log('print "' + "".join(unfinished)[:-1] + '"')
        unfinished.clear()


def run(text):
    fake_hub.reset()
    unfinished.clear()
    try:
        exec(compile(text, "program.py", "exec"), {"__name__": "__main__", "print": show})
        end = "end"
    except SystemExit:
        end = "exit"
    except fake_hub.TimeIsUp:
        end = "time is up"
    except BaseException as error:
        end = "error " + repr(error)
    return state.log + ["# " + end + " " + str(state.clock)]
