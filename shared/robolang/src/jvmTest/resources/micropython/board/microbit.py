# What a micro:bit does, as far as programs can tell without a robot.
import board_world as world
from board_world import state

# What the buggy has on its pins: a function of the pin for each, set before a program runs.
digital_lines = {}
analog_lines = {}
i2c_lines = {}


def running_time():
    world.ask()
    return state.clock


def sleep(milliseconds):
    world.advance(milliseconds)


class I2C:
    def write(self, address, data, repeat=False):
        world.log("i2c 0x%02x" % address, *["%02x" % byte for byte in data])

    def read(self, address, count, repeat=False):
        # What was written last asked for it.
        asked = state.log.pop().split(" ", 1)[1]
        byte = 0
        for line, (ask, bit, dark_is) in i2c_lines.items():
            if ask == asked and world.is_dark(line) == bool(dark_is):
                byte |= 1 << bit
        return bytes([byte] * count)


i2c = I2C()


class Button:
    def __init__(self, name):
        self.name = name

    def is_pressed(self):
        return world.pressed(self.name)

    def was_pressed(self):
        # It is pressed at once, to start.
        return True


button_a = Button("a")
button_b = Button("b")


class Logo:
    def is_touched(self):
        return world.pressed("logo")


pin_logo = Logo()


class Pin:
    def __init__(self, number):
        self.number = number

    def read_digital(self):
        if self.number not in digital_lines:
            return 0
        line, dark_is = digital_lines[self.number]
        return dark_is if world.is_dark(line) else 1 - dark_is

    def read_analog(self):
        line, is_dark_high = analog_lines[self.number]
        grey = world.grey(line)
        # The value whose whole hundredth is this grey.
        level = 100 - grey if is_dark_high else grey
        return (level * 1023 + 99) // 100

    def write_digital(self, value):
        pass

    def write_analog(self, value):
        if not isinstance(value, int) or not 0 <= value <= 1023:
            raise ValueError("value must be between 0 and 1023")
        world.log("pin", self.number, "analog", value)

    def set_analog_period(self, milliseconds):
        world.log("pin", self.number, "period", milliseconds)


for _number in list(range(5)) + list(range(8, 17)):
    globals()["pin%d" % _number] = Pin(_number)


class Image:
    ARROW_W = "<"


class Display:
    def show(self, value):
        if value == Image.ARROW_W and not state.is_started:
            return
        if len(value) != 1:
            raise ValueError("shows for a while")
        world.log("display show", value)

    def scroll(self, value, delay=150, wait=True):
        world.log("display scroll", value)

    def clear(self):
        if state.is_started:
            world.log("display clear")
        else:
            world.start()

    def read_light_level(self):
        return world.light_level()


display = Display()


class Microphone:
    def sound_level(self):
        return world.sound_level()


microphone = Microphone()
