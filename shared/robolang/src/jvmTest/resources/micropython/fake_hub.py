# A hub without a robot: it logs each call in one line and has a clock of its own, in milliseconds. What its sensors
# measure is a function of that clock, the same as in the tests in Kotlin.

LARGEST = (1 << 30) - 1
LIMIT = 20000
MANY = 20000


class TimeIsUp(BaseException):
    pass


class State:
    def __init__(self):
        self.log = []
        self.clock = 0
        self.is_in_tasks = False
        self.asked = 0
        self.is_renewed = False
        self.ports = {}


state = State()


def reset():
    state.__init__()


def log(*words):
    state.log.append(" ".join(str(word) for word in words))


def whole(value):
    # What a hub makes of an argument: fractions go, and whole numbers have 31 bits.
    if not isinstance(value, (int, float)):
        raise TypeError("can't convert %s to int" % type(value).__name__)
    number = int(value)
    if not -LARGEST - 1 <= number <= LARGEST:
        raise OverflowError("small int overflow")
    return number


def figure(value):
    # A length that keeps its thousandths.
    number = int(value * 1000 + 0.5)
    text = "%d.%03d" % (number // 1000, number % 1000)
    return text.rstrip("0").rstrip(".")


def advance(milliseconds):
    state.clock += milliseconds
    state.asked = 0
    if state.clock > LIMIT:
        raise TimeIsUp()


def ask():
    # A loop that only asks would never end, for asking takes no time here.
    state.asked += 1
    if state.asked > MANY:
        raise TimeIsUp()


def renew(owner):
    # A new command of a motor or a driving base: whoever waits for an older one goes on.
    owner.token += 1
    state.is_renewed = True


def passing(milliseconds, owner=None):
    # What takes so long: at once, or, in a task, something to await. A newer command of its owner ends it.
    token = None
    if owner is not None:
        renew(owner)
        token = owner.token
    if not state.is_in_tasks:
        if milliseconds > 0:
            advance(milliseconds)
        return None
    return waiting(state.clock + milliseconds, owner, token)


def waiting(end, owner, token):
    while state.clock < end and (owner is None or owner.token == token):
        yield end


def reading(value):
    # A measured value; in a task it has to be awaited.
    ask()
    return given(value) if state.is_in_tasks else value


def given(value):
    return value
    yield


def take(port, device):
    if state.is_in_tasks:
        raise RuntimeError("This can only be called before multitasking starts.")
    if port in state.ports:
        raise OSError(16)
    state.ports[port] = device
