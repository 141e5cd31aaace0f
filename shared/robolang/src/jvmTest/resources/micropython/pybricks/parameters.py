class Named:
    def __init__(self, name):
        self.name = name
        self.__class__.all[name] = self

    def __repr__(self):
        return type(self).__name__ + "." + self.name


def names_of(kind, names):
    kind.all = {}
    for name in names.split():
        setattr(kind, name, kind(name))


class Port(Named):
    pass


class Stop(Named):
    pass


class Direction(Named):
    pass


class Button(Named):
    pass


class Side(Named):
    pass


class Color:
    all = {}

    def __init__(self, h, s=100, v=100, name=None):
        self.h = h
        self.s = s
        self.v = v
        self.name = name

    def __repr__(self):
        return "Color." + self.name if self.name else "Color(h=%d, s=%d, v=%d)" % (self.h, self.s, self.v)

    def __eq__(self, other):
        return isinstance(other, Color) and (self.h, self.s, self.v) == (other.h, other.s, other.v)

    def __hash__(self):
        return self.h


names_of(Port, "A B C D E F S1 S2 S3 S4")
names_of(Stop, "COAST COAST_SMART BRAKE HOLD NONE")
names_of(Direction, "CLOCKWISE COUNTERCLOCKWISE")
names_of(Button, "LEFT RIGHT CENTER UP DOWN BLUETOOTH")
names_of(Side, "TOP BOTTOM FRONT BACK LEFT RIGHT")

COLORS = {
    "RED": (0, 100, 100),
    "ORANGE": (30, 100, 100),
    "YELLOW": (60, 100, 100),
    "GREEN": (120, 100, 100),
    "CYAN": (180, 100, 100),
    "BLUE": (240, 100, 100),
    "VIOLET": (270, 100, 100),
    "MAGENTA": (300, 100, 100),
    "WHITE": (0, 0, 100),
    "GRAY": (0, 0, 50),
    "BLACK": (0, 0, 10),
    "BROWN": (30, 100, 50),
    "NONE": (0, 0, 0),
}
for name, (h, s, v) in COLORS.items():
    color = Color(h, s, v, name)
    Color.all[name] = color
    setattr(Color, name, color)
