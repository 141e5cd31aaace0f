# Runs a program as a micro:bit does, and gives its log with what became of it as the last line. The first line of the text
# says what the buggy has on its pins.
import board_world as world
import microbit
from board_world import state


def show(*values):
    world.log("print", " ".join(str(value) for value in values))


def set_up(line):
    for lines in (microbit.digital_lines, microbit.analog_lines, microbit.i2c_lines):
        lines.clear()
    for word in line[1:].split("|"):
        parts = word.strip().split(";")
        if parts[0] == "digital":
            microbit.digital_lines[int(parts[1])] = (int(parts[2]), int(parts[3]))
        elif parts[0] == "analog":
            microbit.analog_lines[int(parts[1])] = (int(parts[2]), int(parts[3]))
        elif parts[0] == "i2c":
            microbit.i2c_lines[int(parts[4])] = (parts[1], int(parts[2]), int(parts[3]))


def run(text):
    world.reset()
    set_up(text.split("\n", 1)[0])
    try:
        exec(compile(text, "main.py", "exec"), {"__name__": "__main__", "print": show})
        end = "end"
    except SystemExit:
        end = "exit"
    except world.TimeIsUp:
        end = "time is up"
    except BaseException as error:
        end = "error " + repr(error)
    return state.log + ["# " + end + " " + str(state.clock)]
