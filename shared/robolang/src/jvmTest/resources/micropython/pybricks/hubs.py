import fake_world
from fake_hub import ask, log, passing, state, whole
from pybricks.parameters import Button


def quoted(text):
    if not isinstance(text, str):
        raise TypeError("can't convert %s to str" % type(text).__name__)
    return '"' + text + '"'


class Speaker:
    def beep(self, frequency=500, duration=100):
        log("speaker beep", whole(frequency), whole(duration))
        return passing(max(0, whole(duration)))


class Matrix:
    MS_PER_LETTER = 550

    def number(self, number):
        log("display number", whole(number))

    def text(self, text, on=500, off=50):
        log("display text", quoted(text))
        return passing(len(text) * self.MS_PER_LETTER)

    def char(self, char):
        if not 32 <= ord(char) <= 126:
            raise ValueError("Invalid argument")
        log("display char", quoted(char))

    def off(self):
        log("display off")


class Screen:
    def print(self, value):
        log("screen print", quoted(str(value)))

    def clear(self):
        log("screen clear")


class Light:
    def on(self, color):
        log("light on", color.name)

    def off(self):
        log("light off")


class Buttons:
    def __init__(self, names):
        self.names = names

    def pressed(self):
        ask()
        return {Button.all[name] for name in self.names if fake_world.pressed(name, state.clock)}


class Battery:
    def voltage(self):
        ask()
        return 7500


class System:
    def set_stop_button(self, button):
        log("system set_stop_button", "none" if button is None else button.name)


class Hub:
    def __init__(self):
        self.battery = Battery()
        self.system = System()
        self.buttons = Buttons(("CENTER",))


class PrimeHub(Hub):
    def __init__(self):
        super().__init__()
        self.buttons = Buttons(("LEFT", "RIGHT", "CENTER"))
        self.display = Matrix()
        self.light = Light()
        self.speaker = Speaker()


InventorHub = ThisHub = PrimeHub


class EssentialHub(Hub):
    def __init__(self):
        super().__init__()
        self.light = Light()


TechnicHub = EssentialHub


class EV3Brick(Hub):
    def __init__(self):
        super().__init__()
        self.buttons = Buttons(("LEFT", "RIGHT", "CENTER"))
        self.screen = Screen()
        self.light = Light()
        self.speaker = Speaker()


class NXTBrick(Hub):
    def __init__(self):
        super().__init__()
        self.buttons = Buttons(("LEFT", "RIGHT", "CENTER"))
        self.screen = Screen()
        self.speaker = Speaker()
