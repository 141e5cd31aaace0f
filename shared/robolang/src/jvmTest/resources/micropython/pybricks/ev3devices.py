import fake_world
from fake_hub import reading, state
from pybricks.nxtdevices import TouchSensor
from pybricks.parameters import Color
from pybricks.pupdevices import Motor, Sensor


class ColorSensor(Sensor):
    def reflection(self):
        return reading(fake_world.reflection(state.clock))

    ambient = reflection

    def color(self):
        return reading(Color.all[fake_world.colour(state.clock)])


class UltrasonicSensor(Sensor):
    def distance(self, silent=False):
        return reading(fake_world.distance(state.clock))
