package robotran.world

import robotran.brick.controls.MotorPort
import robotran.brick.kind.BrickKind
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
        ).associateBy { checkNotNull(it.base) }

    /** What a description that names no base has where it says nothing. */
    fun defaultOf(brick: BrickKind): RobotDescription = all.values.first { it.brick == brick }

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

private fun box(back: Double, front: Double, half: Double) =
    listOf(Point(back, -half), Point(front, -half), Point(front, half), Point(back, half))

private fun lightDown(port: Int, at: Point) = SensorPart(port, SensorKind.LIGHT, at, height = 1.0, facing = Facing.Down)

private fun sonar(port: Int, at: Point, height: Double, direction: Double) =
    SensorPart(port, SensorKind.ULTRASONIC, at, height, Facing.Ahead(direction))
