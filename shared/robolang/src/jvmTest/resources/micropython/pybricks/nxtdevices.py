import fake_world
from fake_hub import ask, reading, state
from pybricks.parameters import Color
from pybricks.pupdevices import Motor, Sensor


class TouchSensor(Sensor):
    def pressed(self):
        ask()
        return fake_world.touched(self.name == "S1", state.clock)


class LightSensor(Sensor):
    def reflection(self):
        ask()
        return float(fake_world.reflection(state.clock))

    ambient = reflection


class SoundSensor(Sensor):
    def intensity(self, audible_only=True):
        ask()
        return fake_world.loudness(state.clock)


class ColorSensor(Sensor):
    def reflection(self):
        ask()
        return fake_world.reflection(state.clock)

    def color(self, surface=True):
        ask()
        return Color.all[fake_world.colour(state.clock)]


class UltrasonicSensor(Sensor):
    def distance(self):
        return reading(fake_world.distance(state.clock))
