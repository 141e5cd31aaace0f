package robotran.world

import robotran.brick.controls.MotorPort
import robotran.brick.kind.BrickKind
import robotran.brick.kind.BuggyKind
import robotran.brick.kind.BuggyPins
import robotran.brick.sensors.SensorKind
import robotran.world.geometry.Point

/** The robots that come with Robotran. */
object ReadyRobots {
    /** The robot of every world that does not name another. */
    val RCX_PENBOT = RobotDescription(
        title = "RCX penbot",
        brick = BrickKind.RCX,
        chassis = Chassis(
            box(Penbot.CHASSIS_BACK, Penbot.CHASSIS_FRONT, Penbot.CHASSIS_WIDTH / 2),
            height = 9.0,
            mass = Penbot.MASS,
            massAt = Point(Penbot.MASS_POSITION, 0.0),
        ),
        drive = Drive(
            Penbot.WHEEL_DIAMETER,
            Penbot.WHEEL_WIDTH,
            Penbot.WHEEL_TRACK,
            Penbot.GEAR_REDUCTION,
            MotorPort.A,
            MotorPort.C,
        ),
        casters = listOf(Point(Penbot.CASTER_POSITION, 0.0)),
        pen = PenMount(MotorPort.B),
        brickAt = BrickMount(Point(1.0, 0.0)),
        parts = penbotParts(RobotPlacement.PENBOT_PORTS),
        base = "rcx-penbot",
    )

    /** Its sonar sees what is ahead. */
    val NXT_PENBOT = RobotDescription(
        title = "NXT penbot",
        brick = BrickKind.NXT,
        chassis = Chassis(box(-8.2, 8.2, 4.3), height = 9.0, mass = 0.7, massAt = Point(0.9, 0.0)),
        drive = NXT_DRIVE.copy(track = 11.4),
        casters = listOf(Point(6.5, 0.0)),
        pen = PenMount(MotorPort.B),
        brickAt = BrickMount(Point(0.0, 0.0)),
        parts = listOf(
            BumperPart(1, Point(9.4, 3.4), width = 6.4, side = BumperSide.LEFT),
            BumperPart(2, Point(9.4, -3.4), width = 6.4, side = BumperSide.RIGHT),
            lightDown(3, Point(7.2, 0.0)),
            sonar(4, Point(8.4, 0.0), height = 8.0, direction = 0.0),
        ),
        base = "nxt-penbot",
    )

    /** Two light sensors beside a line, and a colour sensor on it. */
    val LINE_FOLLOWER = RobotDescription(
        title = "Line follower",
        brick = BrickKind.NXT,
        chassis = Chassis(box(-7.0, 7.0, 4.0), height = 8.0, mass = 0.6, massAt = Point(-0.8, 0.0)),
        drive = NXT_DRIVE.copy(wheelDiameter = 4.32, wheelWidth = 2.2, track = 10.6),
        casters = listOf(Point(-5.5, 0.0)),
        pen = null,
        brickAt = BrickMount(Point(-1.0, 0.0)),
        parts = listOf(
            lightDown(1, Point(7.5, 1.5)),
            SensorPart(2, SensorKind.COLOUR, Point(7.5, 0.0), height = 1.0, facing = Facing.Down),
            lightDown(3, Point(7.5, -1.5)),
        ),
        base = "line-follower",
    )

    /** Heavy and broad; it feels who pushes it from behind. */
    val SUMO = RobotDescription(
        title = "Sumo robot",
        brick = BrickKind.NXT,
        chassis = Chassis(box(-9.0, 9.0, 5.5), height = 10.0, mass = 1.0, massAt = Point(0.5, 0.0)),
        drive = NXT_DRIVE.copy(track = 14.0),
        casters = listOf(Point(7.5, 0.0)),
        pen = null,
        brickAt = BrickMount(Point(0.0, 0.0)),
        parts = listOf(
            BumperPart(1, Point(-9.5, 0.0), width = 10.0, direction = 180.0),
            lightDown(3, Point(8.5, 0.0)),
            sonar(4, Point(8.0, 0.0), height = 6.0, direction = 0.0),
        ),
        base = "sumo",
    )

    /** A sonar on each side, to follow walls and to find its way out. */
    val BOTH_SIDES = NXT_PENBOT.copy(
        title = "Sees to both sides",
        chassis = NXT_PENBOT.chassis.copy(mass = 0.75),
        parts = listOf(
            sonar(1, Point(2.0, 5.0), height = 8.0, direction = 90.0),
            BumperPart(2, Point(9.4, 0.0), width = 13.2),
            lightDown(3, Point(7.2, 0.0)),
            sonar(4, Point(2.0, -5.0), height = 8.0, direction = -90.0),
        ),
        base = "both-sides",
    )

    /** The usual driving base of SPIKE Prime with a pen, a colour sensor that looks down and a bumper. */
    val SPIKE_PENBOT = RobotDescription(
        title = "SPIKE penbot",
        brick = BrickKind.SPIKE_PRIME,
        chassis = Chassis(box(-8.0, 8.0, 4.5), height = 8.0, mass = 0.6, massAt = Point(0.6, 0.0)),
        drive = SPIKE_DRIVE,
        casters = listOf(Point(6.5, 0.0)),
        pen = PenMount(MotorPort.C),
        brickAt = BrickMount(Point(0.0, 0.0)),
        parts = listOf(
            SensorPart(4, SensorKind.COLOUR, Point(7.2, 0.0), height = 1.6, facing = Facing.Down),
            BumperPart(5, Point(9.2, 0.0), width = 10.0),
        ),
        base = "spike-penbot",
    )

    /** The same with a distance sensor ahead. */
    val SPIKE_SCOUT = SPIKE_PENBOT.copy(
        title = "SPIKE scout",
        parts = listOf(
            SensorPart(4, SensorKind.COLOUR, Point(7.2, 0.0), height = 1.6, facing = Facing.Down),
            sonar(6, Point(8.4, 0.0), height = 6.0, direction = 0.0),
        ),
        base = "spike-scout",
    )

    /** Two small motors and nothing else: its hub has no more ports. */
    val ESSENTIAL_ROVER = RobotDescription(
        title = "Essential rover",
        brick = BrickKind.SPIKE_ESSENTIAL,
        chassis = Chassis(box(-6.0, 6.0, 3.8), height = 7.0, mass = 0.35, massAt = Point(0.5, 0.0)),
        drive = SPIKE_DRIVE.copy(track = 10.0),
        casters = listOf(Point(5.0, 0.0)),
        pen = null,
        brickAt = BrickMount(Point(0.0, 0.0)),
        parts = emptyList(),
        base = "essential-rover",
    )

    /** A driving base with a Technic Hub, a pen and a colour sensor that looks down. */
    val TECHNIC_PENBOT = SPIKE_PENBOT.copy(
        title = "Technic penbot",
        brick = BrickKind.TECHNIC_HUB,
        parts = listOf(SensorPart(4, SensorKind.COLOUR, Point(7.2, 0.0), height = 1.6, facing = Facing.Down)),
        base = "technic-penbot",
    )

    /** An EV3 on its usual base, with a pen. */
    val EV3_PENBOT = RobotDescription(
        title = "EV3 penbot",
        brick = BrickKind.EV3,
        chassis = Chassis(box(-8.2, 8.2, 4.4), height = 9.0, mass = 0.75, massAt = Point(0.9, 0.0)),
        drive = NXT_DRIVE.copy(track = 12.0, left = MotorPort.B, right = MotorPort.C),
        casters = listOf(Point(6.5, 0.0)),
        pen = PenMount(MotorPort.A),
        brickAt = BrickMount(Point(0.0, 0.0)),
        parts = listOf(
            BumperPart(1, Point(9.4, 3.4), width = 6.4, side = BumperSide.LEFT),
            BumperPart(2, Point(9.4, -3.4), width = 6.4, side = BumperSide.RIGHT),
            SensorPart(3, SensorKind.COLOUR, Point(7.2, 0.0), height = 1.0, facing = Facing.Down),
            sonar(4, Point(8.4, 0.0), height = 8.0, direction = 0.0),
        ),
        base = "ev3-penbot",
    )

    /** The NXT penbot with Pybricks on its brick. */
    val NXT_PYBRICKS_PENBOT = NXT_PENBOT.copy(
        title = "NXT penbot with Pybricks",
        brick = BrickKind.NXT_PYBRICKS,
        base = "nxt-pybricks-penbot",
    )

    /** A Cutebot with a pen that we put between its wheels, on a servo. */
    val CUTEBOT = RobotDescription(
        title = "Cutebot",
        brick = BrickKind.MICROBIT,
        chassis = Chassis(box(-2.8, 5.8, 3.3), height = 5.0, mass = 0.17, massAt = Point(1.0, 0.0)),
        drive = BUGGY_DRIVE.copy(wheelDiameter = 3.6, track = 7.6),
        casters = listOf(Point(4.8, 0.0)),
        pen = PenMount(MotorPort.B),
        brickAt = BrickMount(Point(2.5, 0.0)),
        parts = listOf(
            lineSensor(1, Point(4.2, 0.58)),
            lineSensor(2, Point(4.2, -0.58)),
            sonar(3, Point(5.8, 0.0), height = 3.5, direction = 0.0),
        ),
        buggy = BuggyMount(BuggyKind.CUTEBOT),
        base = "cutebot",
    )

    /** Larger and faster than a Cutebot. */
    val CUTEBOT_PRO = CUTEBOT.copy(
        title = "Cutebot Pro",
        chassis = Chassis(box(-3.9, 9.6, 3.2), height = 6.0, mass = 0.2, massAt = Point(2.0, 0.0)),
        drive = BUGGY_DRIVE.copy(wheelDiameter = 5.0, wheelWidth = 1.0, track = 7.4),
        casters = listOf(Point(7.5, 0.0)),
        brickAt = BrickMount(Point(2.9, 0.0)),
        parts = listOf(
            lineSensor(1, Point(5.3, 0.58)),
            lineSensor(2, Point(5.3, -0.58)),
            sonar(3, Point(9.6, 0.0), height = 4.0, direction = 0.0),
        ),
        buggy = BuggyMount(BuggyKind.CUTEBOT_PRO),
        base = "cutebot-pro",
    )

    val MAQUEEN = CUTEBOT.copy(
        title = "Maqueen",
        chassis = Chassis(box(-2.0, 5.9, 2.6), height = 5.0, mass = 0.13, massAt = Point(1.2, 0.0)),
        drive = BUGGY_DRIVE.copy(wheelDiameter = 4.2, track = 6.2),
        casters = listOf(Point(4.9, 0.0)),
        brickAt = BrickMount(Point(2.4, 0.0)),
        parts = listOf(
            lineSensor(1, Point(3.5, 0.6)),
            lineSensor(2, Point(3.5, -0.6)),
            sonar(3, Point(5.9, 0.0), height = 3.5, direction = 0.0),
        ),
        buggy = BuggyMount(BuggyKind.MAQUEEN),
        base = "maqueen",
    )

    /** Three of its five line sensors are on ports. */
    val MAQUEEN_PLUS = CUTEBOT.copy(
        title = "Maqueen Plus",
        chassis = Chassis(box(-2.7, 7.3, 3.6), height = 5.5, mass = 0.21, massAt = Point(1.5, 0.0)),
        drive = BUGGY_DRIVE.copy(wheelDiameter = 4.3, track = 8.2),
        casters = listOf(Point(5.8, 0.0)),
        brickAt = BrickMount(Point(2.3, 0.0)),
        parts = listOf(
            lineSensor(1, Point(5.3, 0.9)),
            lineSensor(2, Point(5.3, 0.0)),
            lineSensor(3, Point(5.3, -0.9)),
            sonar(4, Point(7.3, 0.0), height = 3.5, direction = 0.0),
        ),
        buggy = BuggyMount(BuggyKind.MAQUEEN_PLUS),
        base = "maqueen-plus",
    )

    /** Round, and without a plug for the servo of a pen. */
    val TINY_BIT = CUTEBOT.copy(
        title = "Tiny:bit",
        chassis = Chassis(
            listOf(
                Point(-3.1, -1.6),
                Point(0.2, -3.1),
                Point(5.0, -2.6),
                Point(6.9, 0.0),
                Point(5.0, 2.6),
                Point(0.2, 3.1),
                Point(-3.1, 1.6),
            ),
            height = 5.0,
            mass = 0.18,
            massAt = Point(1.3, 0.0),
        ),
        drive = BUGGY_DRIVE.copy(wheelDiameter = 4.2, track = 7.2),
        casters = listOf(Point(5.0, 0.0)),
        pen = null,
        brickAt = BrickMount(Point(1.9, 0.0)),
        parts = listOf(
            lineSensor(1, Point(4.2, 1.15)),
            lineSensor(2, Point(4.2, -1.15)),
            sonar(3, Point(6.9, 0.0), height = 3.5, direction = 0.0),
        ),
        buggy = BuggyMount(BuggyKind.TINY_BIT),
        base = "tiny-bit",
    )

    /** With the hole for a pen that its maker has put between the wheels. */
    val KITRONIK_PENBOT = CUTEBOT.copy(
        title = "Kitronik :MOVE Motor",
        chassis = Chassis(box(-3.5, 6.5, 3.6), height = 5.0, mass = 0.25, massAt = Point(1.0, 0.0)),
        drive = BUGGY_DRIVE.copy(wheelDiameter = 5.5, wheelWidth = 1.0, track = 8.4),
        casters = listOf(Point(5.0, 0.0)),
        brickAt = BrickMount(Point(2.5, 0.0)),
        parts = listOf(
            lineSensor(1, Point(4.5, 0.6)),
            lineSensor(2, Point(4.5, -0.6)),
            sonar(3, Point(6.5, 0.0), height = 4.0, direction = 0.0),
        ),
        buggy = BuggyMount(BuggyKind.KITRONIK_MOVE),
        base = "kitronik-penbot",
    )

    /** Two continuous servos, a third one for the pen, and no sensors: any board of a pupil's own. */
    val PLAIN_BUGGY = CUTEBOT.copy(
        title = "micro:bit buggy",
        chassis = Chassis(box(-3.0, 6.0, 3.6), height = 5.0, mass = 0.2, massAt = Point(1.0, 0.0)),
        drive = BUGGY_DRIVE.copy(wheelDiameter = 6.0, wheelWidth = 1.0, track = 9.0),
        casters = listOf(Point(5.0, 0.0)),
        brickAt = BrickMount(Point(2.5, 0.0)),
        parts = emptyList(),
        buggy = BuggyMount(BuggyKind.PLAIN, pins = BuggyPins.SERVOS.copy(pen = 0)),
        base = "plain-buggy",
    )

    /** A Cutebot with a micro:bit V1. */
    val CUTEBOT_V1 = CUTEBOT.copy(
        title = "Cutebot with micro:bit V1",
        brick = BrickKind.MICROBIT_V1,
        base = "cutebot-v1",
    )

    /** By the name in files. The first with a kind of brick is the penbot of that brick. */
    val all: Map<String, RobotDescription> =
        listOf(
            RCX_PENBOT,
            NXT_PENBOT,
            LINE_FOLLOWER,
            SUMO,
            BOTH_SIDES,
            SPIKE_PENBOT,
            SPIKE_SCOUT,
            ESSENTIAL_ROVER,
            TECHNIC_PENBOT,
            EV3_PENBOT,
            NXT_PYBRICKS_PENBOT,
            CUTEBOT,
            CUTEBOT_PRO,
            MAQUEEN,
            MAQUEEN_PLUS,
            TINY_BIT,
            KITRONIK_PENBOT,
            PLAIN_BUGGY,
            CUTEBOT_V1,
        ).associateBy { checkNotNull(it.base) }

    /** What a description that names no base has where it says nothing. */
    fun defaultOf(brick: BrickKind): RobotDescription = all.values.first { it.brick == brick }

    /** The robot with this buggy and this [board]. */
    fun on(buggy: BuggyKind, board: BrickKind = BrickKind.MICROBIT): RobotDescription {
        val ready = all.values.filter { it.buggy?.kind == buggy }
        return ready.firstOrNull { it.brick == board } ?: ready.first().copy(brick = board)
    }

    /** The penbot with these sensors on its ports, see [RobotPlacement.ports]. */
    fun penbotWith(ports: List<List<PortSensor>>): RobotDescription = RCX_PENBOT.copy(parts = penbotParts(ports))
}

private val NXT_DRIVE = Drive(
    wheelDiameter = 5.6,
    wheelWidth = 2.6,
    track = 11.4,
    gear = 1.0,
    left = MotorPort.A,
    right = MotorPort.C,
)

private val SPIKE_DRIVE = Drive(
    wheelDiameter = 5.6,
    wheelWidth = 1.4,
    track = 11.2,
    gear = 1.0,
    left = MotorPort.A,
    right = MotorPort.B,
)

/** A wheel with a narrow rubber tyre. */
private val BUGGY_DRIVE = Drive(
    wheelDiameter = 4.2,
    wheelWidth = 0.8,
    track = 7.2,
    gear = 1.0,
    left = MotorPort.A,
    right = MotorPort.C,
)

private fun box(back: Double, front: Double, half: Double) =
    listOf(Point(back, -half), Point(front, -half), Point(front, half), Point(back, half))

private fun lightDown(port: Int, at: Point) = SensorPart(port, SensorKind.LIGHT, at, height = 1.0, facing = Facing.Down)

/** Half a centimetre over the floor. */
private fun lineSensor(port: Int, at: Point) =
    SensorPart(port, SensorKind.LIGHT, at, height = 0.5, facing = Facing.Down)

private fun sonar(port: Int, at: Point, height: Double, direction: Double) =
    SensorPart(port, SensorKind.ULTRASONIC, at, height, Facing.Ahead(direction))
