package robotran.world.file

import io.kotest.property.Arb
import io.kotest.property.arbitrary.arbitrary
import robotran.brick.controls.MotorPort
import robotran.brick.kind.BrickKind
import robotran.brick.kind.BuggyKind
import robotran.brick.kind.BuggyPins
import robotran.brick.kind.PlainDrive
import robotran.brick.kind.WheelTrim
import robotran.brick.sensors.SensorKind
import robotran.world.BrickMount
import robotran.world.BuggyMount
import robotran.world.BumperPart
import robotran.world.BumperSide
import robotran.world.Chassis
import robotran.world.Drive
import robotran.world.Facing
import robotran.world.FingerTouchPart
import robotran.world.PenMount
import robotran.world.ReadyRobots
import robotran.world.RobotDescription
import robotran.world.RobotPart
import robotran.world.RotationPart
import robotran.world.SensorPart
import robotran.world.geometry.Point
import robotran.world.robot.rounded
import kotlin.random.Random

/** Descriptions of all kinds, possible and impossible ones, with at most three decimals. */
internal fun arbitraryRobots(brick: BrickKind? = null): Arb<RobotDescription> =
    arbitrary { ArbitraryRobot(it.random, brick).robot() }

/** Most figures are sensible and some are not, so that about half of the robots can be built. */
private class ArbitraryRobot(private val random: Random, private val wanted: BrickKind?) {
    fun robot(): RobotDescription {
        val brick = wanted ?: BrickKind.entries.random(random)
        val base = if (random.nextBoolean()) {
            ReadyRobots.all.values.filter { it.brick == brick }.random(random)
        } else {
            null
        }
        val like = base ?: ReadyRobots.defaultOf(brick)
        val front = number(3.0, 15.0)
        val motors = brick.motorPorts.shuffled(random)
        val drive = if (random.nextInt(4) == 0) like.drive else drive(motors)
        val pen = if (random.nextBoolean()) null else motors.getOrNull(rarely(0, 2))?.let(::PenMount)
        // On a port with a letter is a motor or a sensor.
        val taken = if (brick.hasLetteredInputs) listOfNotNull(drive.left, drive.right, pen?.motor) else emptyList()
        val ports = (1..brick.inputPorts) - taken.map { it.ordinal + 1 }.toSet()
        return RobotDescription(
            title = "Robot ${random.nextInt(100)}",
            brick = brick,
            chassis = if (random.nextInt(4) == 0) like.chassis else chassis(front),
            drive = drive,
            casters = if (random.nextInt(4) == 0) like.casters else casters(front),
            pen = pen,
            brickAt = BrickMount(Point(number(-3.0, 3.0), 0.0), random.nextBoolean()),
            parts = if (random.nextInt(4) == 0) like.parts else parts(brick, ports.shuffled(random), front),
            buggy = like.buggy?.let { if (random.nextBoolean()) it else buggy() },
            base = base?.base,
        ).rounded()
    }

    private fun buggy(): BuggyMount {
        val kind = BuggyKind.entries.random(random)
        val trim = if (random.nextBoolean()) WheelTrim.NONE else WheelTrim(1.0, number(0.8, 1.0))
        return BuggyMount(kind, trim, if (kind == BuggyKind.PLAIN) pins() else null)
    }

    private fun pins(): BuggyPins {
        val pins = BuggyPins.USABLE.shuffled(random)
        val drive = PlainDrive.entries.random(random)
        val (left, right) = pins.chunked(drive.pinsOfWheel).take(2)
        val rest = pins.drop(2 * drive.pinsOfWheel)
        return BuggyPins(
            drive,
            left,
            right,
            rest.take(random.nextInt(BuggyPins.MOST_LINES)),
            isDarkOne = random.nextBoolean(),
            trigger = rest[BuggyPins.MOST_LINES].takeIf { random.nextBoolean() },
            pen = rest[BuggyPins.MOST_LINES + 1].takeIf { random.nextBoolean() },
        )
    }

    private fun chassis(front: Double): Chassis {
        val back = -number(3.0, 12.0)
        val half = number(2.0, 9.0)
        val outline = when (random.nextInt(4)) {
            0 -> listOf(Point(back, -half), Point(front, -half / 2), Point(front, half / 2), Point(back, half))

            1 -> listOf(
                Point(back, -half),
                Point(front, -half),
                Point(front / 2, 0.0),
                Point(front, half),
                Point(back, half),
            )

            2 -> List(random.nextInt(3, 13)) { Point(number(back, front), number(-half, half)) }
            else -> listOf(Point(back, -half), Point(front, -half), Point(front, half), Point(back, half))
        }
        val massAt = Point(if (random.nextInt(6) == 0) -1.0 else number(0.0, 2.0), 0.0)
        return Chassis(outline, number(4.0, 15.0), number(0.1, 2.0), massAt)
    }

    private fun drive(motors: List<MotorPort>) = Drive(
        wheelDiameter = number(2.0, 10.0),
        wheelWidth = number(0.5, 4.0),
        track = number(4.0, 25.0),
        gear = if (random.nextInt(4) == 0) number(0.2, 12.0) else number(2.0, 6.0),
        left = motors[0],
        right = motors[rarely(0, 1)],
        reversed = random.nextBoolean(),
        tyreFriction = number(0.1, 2.0),
    )

    private fun casters(front: Double) = List(
        if (random.nextInt(6) == 0) {
            0
        } else {
            random.nextInt(1, 4)
        },
    ) { Point(front - number(0.0, 2.0), number(-4.0, 4.0)) }

    private fun parts(brick: BrickKind, ports: List<Int>, front: Double): List<RobotPart> =
        List(random.nextInt(ports.size + 1)) {
            part(brick, ports[it].takeUnless { random.nextInt(5) == 0 }, front)
        }

    private fun part(brick: BrickKind, port: Int?, front: Double): RobotPart = when (random.nextInt(6)) {
        0 -> FingerTouchPart(port)
        1 -> RotationPart(port, BumperSide.entries.random(random))
        2, 3 -> bumper(port, front)
        else -> sensor(brick, port, front)
    }

    private fun bumper(port: Int?, front: Double) = BumperPart(
        port,
        Point(front + number(-0.5, 4.0), number(-5.0, 5.0)),
        width = number(1.0, 15.0),
        depth = number(0.5, 4.0),
        direction = if (random.nextBoolean()) 0.0 else number(-60.0, 60.0),
        side = if (random.nextBoolean()) BumperSide.entries.random(random) else null,
    )

    private fun sensor(brick: BrickKind, port: Int?, front: Double): SensorPart {
        val usual = SensorKind.LIGHT.takeIf { it in brick.sensors } ?: SensorKind.COLOUR
        val kind = if (random.nextInt(3) > 0) usual else (SensorKind.entries - OTHER_PARTS).random(random)
        val facing = when (random.nextInt(4)) {
            0 -> Facing.Down
            1 -> Facing.Free
            else -> Facing.Ahead(number(-90.0, 90.0))
        }
        val at = Point(front + number(-1.0, 3.0), number(-5.0, 5.0))
        val turret = if (random.nextInt(8) == 0) BrickKind.default.motorPorts.random(random) else null
        return SensorPart(port, kind, at, number(0.5, if (facing is Facing.Ahead) 10.0 else 3.5), facing, turret)
    }

    private fun number(from: Double, to: Double): Double {
        val any = random.nextDouble(from, to)
        return if (random.nextBoolean()) any else (any * 2).toInt() / 2.0
    }

    /** [rare] in one of ten cases, otherwise [usual]. */
    private fun rarely(rare: Int, usual: Int) = if (random.nextInt(10) == 0) rare else usual

    private companion object {
        val OTHER_PARTS = setOf(SensorKind.TOUCH, SensorKind.ROTATION)
    }
}
