package robotran.world.messages

import robotran.brick.controls.MotorPort
import robotran.brick.kind.BrickKind
import robotran.brick.sensors.SensorKind
import robotran.json.messages.alternatives
import robotran.world.robot.RobotFigure

internal object EnglishRobotMessages : RobotMessages {
    override fun notARobot(format: String) = "This is not a Robotran robot: a robot file says \"format\": \"$format\"."

    override fun newerRobot(version: Int, known: Int) =
        "This robot was made by a newer Robotran (it has version $version, this Robotran reads up to $known)."

    override fun noReadyRobot(name: String, known: List<String>) =
        "There is no ready robot called \"$name\", only ${alternatives(known, "and")}."

    override fun robotAndPorts() =
        "A robot has either \"robot\" or \"ports\": what is plugged into a robot is in its own parts."

    override fun outOfRange(figure: RobotFigure, lowest: String, highest: String) =
        "${subject(figure)} from $lowest to $highest${unit(figure)}."

    override fun portTaken(port: Int) = "Two things are plugged into port $port."

    override fun noSuchPort(brick: BrickKind, port: Int) = "An ${brick.name} has no port $port."

    override fun unreadable(brick: BrickKind, kind: SensorKind): String {
        val article = if (name(kind).first() in "aeiouRN") "an" else "a"
        return "An ${brick.name} cannot read $article ${name(kind)}."
    }

    override fun oneDriveMotor(motor: MotorPort) =
        "Two motors are needed to drive, but left and right are both motor ${motor.name}."

    override fun penMotorTaken(motor: MotorPort) = "Motor ${motor.name} drives a wheel, so it cannot lift the pen."

    override fun noWheels() = "A robot needs two wheels: give them a diameter from 2 to 10 cm."

    override fun wheelsTooClose() = "The wheels are inside each other: the track must be wider than a tyre."

    override fun tooFast() = "With this gear the robot is faster than 60 cm a second."

    override fun tipsOver(backwards: Boolean) = if (backwards) {
        "The robot tips over: its mass lies behind the wheels, and no caster holds it there."
    } else {
        "The robot tips over: its mass lies in front of the wheels, and no caster holds it there."
    }

    override fun casterOnAxle() = "A caster must be at least 1 cm in front of the axle or behind it."

    override fun outlineCrosses() = "The outline crosses or touches itself."

    override fun outlineTooSmall() = "The outline is too small: it must be at least 4 cm long and wide."

    override fun outlineTooLarge() = "The outline is too large: it must be at most 60 cm long and wide."

    override fun tooManyCorners() = "The outline has too many corners for so many bumpers."

    override fun massOutside() = "The mass lies outside of the outline."

    override fun massBesideMiddle() = "The mass must lie on the middle line, at y 0."

    override fun bumperInside() = "The bumper is inside the robot."

    override fun sensorInFloor(kind: SensorKind, lowest: String) =
        "The ${name(kind)} is inside the floor: put it at least $lowest cm high."

    override fun sensorTooHigh(kind: SensorKind, highest: String) =
        "The ${name(kind)} looks at the floor from too high: at most $highest cm."

    override fun cannotLookDown(kind: SensorKind) = "The ${name(kind)} must have a direction and cannot look down."

    override fun looksIntoRobot(kind: SensorKind) = "The ${name(kind)} looks into the robot itself."

    override fun farAway(kind: SensorKind, centimetres: Int) =
        "The ${name(kind)} is $centimetres cm away from the robot: at most 15 cm."

    override fun turretMotorTaken(motor: MotorPort, byPen: Boolean) = if (byPen) {
        "Motor ${motor.name} turns a sensor and lifts the pen."
    } else {
        "Motor ${motor.name} turns a sensor and drives a wheel."
    }

    override fun noTurret(brick: BrickKind) = "The motors of an ${brick.name} cannot turn a sensor: they do not count."

    private fun name(kind: SensorKind) = when (kind) {
        SensorKind.TOUCH -> "bumper"
        SensorKind.TEMPERATURE -> "temperature sensor"
        SensorKind.LIGHT -> "light sensor"
        SensorKind.ROTATION -> "rotation sensor"
        SensorKind.ULTRASONIC -> "ultrasonic sensor"
        SensorKind.SOUND -> "sound sensor"
        SensorKind.COLOUR -> "colour sensor"
        SensorKind.COMPASS -> "compass"
        SensorKind.GYRO -> "gyro sensor"
        SensorKind.HITECHNIC_COLOUR -> "HiTechnic colour sensor"
        SensorKind.MINDSENSORS_COMPASS -> "mindsensors compass"
        SensorKind.HITECHNIC_ACCELERATION -> "HiTechnic acceleration sensor"
        SensorKind.MINDSENSORS_ACCELERATION -> "mindsensors acceleration sensor"
        SensorKind.RCX_LIGHT -> "RCX light sensor"
        SensorKind.RCX_LINK -> "RCX link"
        SensorKind.OPTICAL_DISTANCE -> "optical distance sensor"
        SensorKind.NXT_TEMPERATURE -> "NXT temperature sensor"
        SensorKind.INFRARED_SEEKER -> "infrared seeker"
        SensorKind.INFRARED_SEEKER_2 -> "infrared seeker V2"
    }

    private fun subject(figure: RobotFigure) = when (figure) {
        RobotFigure.COORDINATE -> "A place on the robot must be"
        RobotFigure.CORNERS -> "The number of corners must be"
        RobotFigure.HEIGHT -> "The height must be"
        RobotFigure.MASS -> "The mass must be"
        RobotFigure.WHEEL_WIDTH -> "The width of a tyre must be"
        RobotFigure.TRACK -> "The track must be"
        RobotFigure.GEAR -> "The gear must be"
        RobotFigure.TYRE_FRICTION -> "The grip of the tyres must be"
        RobotFigure.CASTERS -> "The number of casters must be"
        RobotFigure.PARTS -> "The number of parts must be"
        RobotFigure.BUMPER_WIDTH -> "The width of a bumper must be"
        RobotFigure.BUMPER_DEPTH -> "The depth of a bumper must be"
        RobotFigure.SENSOR_HEIGHT -> "The height of a sensor must be"
        RobotFigure.ANGLE -> "A direction must be"
    }

    private fun unit(figure: RobotFigure) = unitOf(figure, degrees = "degrees")
}

/** Behind a number, with a blank; empty for a mere number. */
internal fun unitOf(figure: RobotFigure, degrees: String): String = when (figure) {
    RobotFigure.MASS -> " kg"
    RobotFigure.ANGLE -> " $degrees"
    RobotFigure.CORNERS, RobotFigure.GEAR, RobotFigure.TYRE_FRICTION, RobotFigure.CASTERS, RobotFigure.PARTS -> ""
    RobotFigure.COORDINATE, RobotFigure.HEIGHT, RobotFigure.WHEEL_WIDTH, RobotFigure.TRACK, RobotFigure.BUMPER_WIDTH,
    RobotFigure.BUMPER_DEPTH, RobotFigure.SENSOR_HEIGHT,
    -> " cm"
}
