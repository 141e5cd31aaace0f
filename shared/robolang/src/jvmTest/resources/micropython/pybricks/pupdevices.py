import fake_world
from fake_hub import ask, log, passing, reading, renew, state, take, whole
from pybricks.parameters import Color, Direction, Stop

MS_PER_DEGREE = 2


class Motor:
    def __init__(self, port, positive_direction=Direction.CLOCKWISE, gears=None, reset_angle=True, profile=None):
        take(port, self)
        self.name = port.name
        self.token = 0
        self.rest = 0
        self.speed_now = 0
        self.since = self.until = state.clock
        turned = " counterclockwise" if positive_direction is Direction.COUNTERCLOCKWISE else ""
        log("device Motor", self.name + turned)

    def angle(self):
        return self.rest + self.speed_now * (state.clock - self.since) // 1000

    def done(self):
        ask()
        return self.speed_now == 0 and state.clock >= self.until

    def stand(self):
        self.rest = self.angle()
        self.speed_now = 0
        self.since = self.until = state.clock
        renew(self)

    def run(self, speed):
        self.stand()
        self.speed_now = whole(speed)
        log("motor", self.name, "run", self.speed_now)

    def run_angle(self, speed, rotation_angle, then=Stop.HOLD, wait=True):
        self.stand()
        degrees = whole(rotation_angle)
        log("motor", self.name, "run_angle", whole(speed), str(degrees) + ("" if wait else " nowait"))
        self.rest += degrees
        self.until = state.clock + abs(degrees) * MS_PER_DEGREE
        return passing(abs(degrees) * MS_PER_DEGREE, self) if wait else None

    def run_target(self, speed, target_angle, then=Stop.HOLD, wait=True):
        self.stand()
        target = whole(target_angle)
        log("motor", self.name, "run_target", whole(speed), target)
        degrees = target - self.rest
        self.rest = target
        self.until = state.clock + abs(degrees) * MS_PER_DEGREE
        return passing(abs(degrees) * MS_PER_DEGREE, self) if wait else None

    def brake(self):
        self.stand()
        log("motor", self.name, "brake")

    def stop(self):
        self.stand()
        log("motor", self.name, "stop")

    def hold(self):
        self.stand()
        log("motor", self.name, "hold")

    def reset_angle(self, angle=None):
        self.stand()
        self.rest = whole(angle)
        log("motor", self.name, "reset_angle", self.rest)


class Sensor:
    def __init__(self, port):
        take(port, self)
        self.name = port.name
        log("device", type(self).__name__, self.name)

    def detectable_colors(self, colors):
        log("sensor", self.name, "detectable_colors", ",".join(color.name for color in colors))


class ColorSensor(Sensor):
    def reflection(self):
        return reading(fake_world.reflection(state.clock))

    def ambient(self):
        return reading(float(fake_world.reflection(state.clock)))

    def color(self, surface=True):
        return reading(Color.all[fake_world.colour(state.clock)])


class UltrasonicSensor(Sensor):
    def distance(self):
        return reading(fake_world.distance(state.clock))


class ForceSensor(Sensor):
    def touched(self):
        return reading(fake_world.touched(self.name == "E", state.clock))

    pressed = touched
