from fake_hub import ask, figure, log, passing, renew, state, whole
from pybricks.parameters import Stop

MS_PER_MM = 5
MS_PER_DEGREE = 5


class DriveBase:
    def __init__(self, left_motor, right_motor, wheel_diameter, axle_track):
        self.token = 0
        self.until = 0
        log("drive_base create", figure(wheel_diameter), figure(axle_track))

    def settings(self, straight_speed, turn_rate):
        if whole(straight_speed) == 0 or whole(turn_rate) == 0:
            raise ValueError("Invalid argument")
        log("drive_base settings", whole(straight_speed), whole(turn_rate))

    def straight(self, distance, then=Stop.HOLD, wait=True):
        log("drive_base straight", whole(distance))
        return self.move(abs(whole(distance)) * MS_PER_MM, wait)

    def turn(self, angle, then=Stop.HOLD, wait=True):
        log("drive_base turn", whole(angle))
        return self.move(abs(whole(angle)) * MS_PER_DEGREE, wait)

    def move(self, time, wait):
        self.until = state.clock + time
        return passing(time, self) if wait else None

    def done(self):
        ask()
        return self.until is not None and state.clock >= self.until

    def drive(self, speed, turn_rate):
        renew(self)
        self.until = None
        log("drive_base drive", whole(speed), whole(turn_rate))

    def brake(self):
        renew(self)
        self.until = state.clock
        log("drive_base brake")

    def stop(self):
        renew(self)
        self.until = state.clock
        log("drive_base stop")
