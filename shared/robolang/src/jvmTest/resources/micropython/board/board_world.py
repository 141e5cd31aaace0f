# A micro:bit without a robot: it logs each call with its time and has a clock of its own, in milliseconds. What its sensors
# measure is a function of that clock, the same as in the tests in Kotlin.

LIMIT = 20000
MANY = 20000


class TimeIsUp(BaseException):
    pass


class State:
    def __init__(self):
        self.log = []
        self.clock = 0
        self.asked = 0
        self.is_started = False
        self.is_over = False


state = State()


def reset():
    state.__init__()


def log(*words):
    state.log.append("%d " % state.clock + " ".join(str(word) for word in words))


def start():
    # The program's own lines begin.
    state.log.append("# begin")
    state.is_started = True


def advance(milliseconds):
    if not isinstance(milliseconds, int):
        raise TypeError("can't convert float to int")
    if milliseconds < 0:
        raise ValueError("invalid arguments")
    state.clock += milliseconds
    if milliseconds > 0:
        state.asked = 0
    if state.clock > LIMIT and not state.is_over:
        state.is_over = True
        state.clock = LIMIT
        raise TimeIsUp()


def ask():
    # A loop that only asks would never end, for asking takes no time here.
    state.asked += 1
    if state.asked > MANY and not state.is_over:
        state.is_over = True
        raise TimeIsUp()


def pressed(button):
    ask()
    time = state.clock
    if button == "logo":
        return 600 <= time % 3000 < 1000
    first = 1500 if button == "a" else 2700
    return first <= time % 4000 < first + 300


def is_dark(line):
    ask()
    return (state.clock + 400 * line) % 2600 >= 1300


def grey(line):
    return 20 if is_dark(line) else 60


def distance():
    ask()
    return 15 if state.clock % 5000 >= 3000 else 90


def light_level():
    ask()
    return 51 if state.clock % 2600 >= 1300 else 204


def sound_level():
    ask()
    return 204 if state.clock % 3000 >= 2000 else 51
