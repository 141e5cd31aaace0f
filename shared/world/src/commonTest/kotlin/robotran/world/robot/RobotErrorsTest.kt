package robotran.world.robot

import robotran.brick.controls.MotorPort
import robotran.brick.sensors.SensorKind
import robotran.language.Language
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
import robotran.world.messages.sentence
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertTrue

/** Every impossible robot is told in a sentence. */
class RobotErrorsTest {
    private val rcx = ReadyRobots.RCX_PENBOT
    private val nxt = ReadyRobots.NXT_PENBOT

    private fun error(robot: RobotDescription): RobotError = robotErrors(robot).first().also { error ->
        val sentences = Language.entries.map(error::sentence)
        assertEquals(sentences.size, sentences.toSet().size, "$sentences")
        for (sentence in sentences) assertTrue(sentence.endsWith(".") && sentence.first().isUpperCase(), sentence)
    }

    private fun described(robot: RobotDescription): String = error(robot).sentence(Language.ENGLISH)

    private fun RobotDescription.chassis(change: Chassis.() -> Chassis) = copy(chassis = chassis.change())

    private fun RobotDescription.drive(change: Drive.() -> Drive) = copy(drive = drive.change())

    private fun RobotDescription.with(vararg parts: RobotPart) = copy(parts = parts.toList())

    private fun sensor(kind: SensorKind, facing: Facing, height: Double = 6.0, at: Point = Point(9.0, 0.0)) =
        SensorPart(1, kind, at, height, facing)

    @Test
    fun `two things on a port`() {
        val two = nxt.with(FingerTouchPart(2), sensor(SensorKind.SOUND, Facing.Ahead(0.0)).on(2))
        assertEquals("Two things are plugged into port 2.", described(two))
        assertEquals(1, error(two).part)
        assertEquals(emptyList(), robotErrors(rcx.with(FingerTouchPart(2), RotationPart(2, BumperSide.LEFT))))
        val three = rcx.with(FingerTouchPart(2), RotationPart(2, BumperSide.LEFT), RotationPart(2, BumperSide.RIGHT))
        assertEquals(RobotError.PortTaken(2, 2), error(three))
        assertEquals(RobotError.PortTaken(1, 2), error(rcx.with(FingerTouchPart(2), FingerTouchPart(2))))
    }

    @Test
    fun `ports and sensors that a brick does not have`() {
        assertEquals("An RCX has no port 4.", described(rcx.with(FingerTouchPart(4))))
        val sonar = sensor(SensorKind.ULTRASONIC, Facing.Ahead(0.0))
        assertEquals("An RCX cannot read an ultrasonic sensor.", described(rcx.with(sonar)))
        val foreign = sensor(SensorKind.MINDSENSORS_COMPASS, Facing.Ahead(0.0))
        assertEquals("An RCX cannot read a mindsensors compass.", described(rcx.with(foreign)))
        assertEquals("An RCX cannot read an RCX link.", described(rcx.with(foreign.copy(sensor = SensorKind.RCX_LINK))))
        val warm = sensor(SensorKind.TEMPERATURE, Facing.Ahead(0.0))
        assertEquals(emptyList(), robotErrors(nxt.with(RotationPart(1, BumperSide.LEFT), warm.on(2))))
        assertEquals(emptyList(), robotErrors(rcx.with(sonar.copy(port = null))))
    }

    @Test
    fun `motors with two purposes`() {
        assertEquals(
            "Two motors are needed to drive, but left and right are both motor A.",
            described(rcx.drive { copy(right = MotorPort.A) }),
        )
        assertEquals(
            "Motor C drives a wheel, so it cannot lift the pen.",
            described(rcx.copy(pen = PenMount(MotorPort.C))),
        )
        val turret = sensor(SensorKind.ULTRASONIC, Facing.Ahead(0.0)).copy(turret = MotorPort.B)
        assertEquals("Motor B turns a sensor and lifts the pen.", described(nxt.with(turret)))
        assertEquals(emptyList(), robotErrors(nxt.copy(pen = null).with(turret)))
        assertEquals(
            "Motor A turns a sensor and drives a wheel.",
            described(nxt.with(turret.copy(turret = MotorPort.A))),
        )
        val light = sensor(SensorKind.LIGHT, Facing.Ahead(0.0)).copy(turret = MotorPort.B)
        assertEquals(
            "The motors of an RCX cannot turn a sensor: they do not count.",
            described(rcx.copy(pen = null).with(light)),
        )
    }

    @Test
    fun `wheels that are none, too close or too fast`() {
        assertEquals(RobotError.NoWheels, error(rcx.drive { copy(wheelDiameter = 0.0) }))
        assertEquals(RobotError.WheelsTooClose, error(rcx.drive { copy(track = 4.0, wheelWidth = 4.0) }))
        assertEquals(RobotError.TooFast, error(rcx.drive { copy(gear = 0.4) }))
        // Even with the highest gear and the smallest wheels, an RCX moves.
        assertEquals(emptyList(), robotErrors(rcx.drive { copy(gear = 12.0, wheelDiameter = 2.0) }))
    }

    @Test
    fun `robots that tip over`() {
        assertEquals(
            "The robot tips over: its mass lies behind the wheels, and no caster holds it there.",
            described(rcx.chassis { copy(massAt = Point(-1.0, 0.0)) }),
        )
        assertEquals(RobotError.TipsOver(backwards = false), error(rcx.copy(casters = emptyList())))
        assertEquals(RobotError.TipsOver(backwards = false), error(rcx.chassis { copy(massAt = Point(7.0, 0.0)) }))
        assertEquals(RobotError.CasterOnAxle, error(rcx.copy(casters = listOf(Point(0.9, 0.0)))))
        assertEquals(RobotError.MassOutside, error(rcx.chassis { copy(massAt = Point(9.0, 0.0)) }))
        assertEquals(RobotError.MassBesideMiddle, error(rcx.chassis { copy(massAt = Point(1.0, 0.5)) }))
        assertEquals(
            emptyList(),
            robotErrors(
                rcx.copy(casters = emptyList()).chassis {
                    copy(massAt = Point(0.0, 0.0))
                },
            ),
        )
    }

    @Test
    fun `outlines that are none`() {
        fun outline(vararg corners: Pair<Int, Int>) =
            rcx.chassis { copy(outline = corners.map { (x, y) -> Point(x.toDouble(), y.toDouble()) }) }
        assertEquals(RobotError.OutlineCrosses, error(outline(-5 to -5, 5 to 5, 5 to -5, -5 to 5)))
        assertEquals(RobotError.OutlineTooSmall, error(outline(0 to 0, 3 to 0, 3 to 5)))
        assertEquals(RobotError.OutlineTooLarge, error(outline(-31 to -5, 31 to -5, 0 to 5)))
        val star = outline(
            -9 to -9,
            0 to -2,
            9 to -9,
            5 to -1,
            9 to 0,
            5 to 1,
            9 to 9,
            0 to 2,
            -9 to 9,
            -5 to 1,
            -9 to 0,
            -5 to -1,
        )
        assertEquals(emptyList(), robotErrors(star))
        val bumpers = List(5) { BumperPart(null, Point(12.0 + it, 0.0), 3.0) }
        assertEquals(RobotError.TooManyCorners, error(star.copy(parts = bumpers)))
    }

    @Test
    fun `sensors where they cannot be`() {
        assertEquals(
            "The ultrasonic sensor is inside the floor: put it at least 2 cm high.",
            described(nxt.with(sensor(SensorKind.ULTRASONIC, Facing.Ahead(0.0), height = 1.0))),
        )
        assertEquals(
            RobotError.SensorInFloor(0, SensorKind.COLOUR, 0.5),
            error(nxt.with(sensor(SensorKind.COLOUR, Facing.Down, height = 0.4))),
        )
        assertEquals(
            "The light sensor looks at the floor from too high: at most 3 cm.",
            described(rcx.with(sensor(SensorKind.LIGHT, Facing.Down, height = 3.5))),
        )
        assertEquals(
            RobotError.CannotLookDown(0, SensorKind.ULTRASONIC),
            error(nxt.with(sensor(SensorKind.ULTRASONIC, Facing.Down))),
        )
        assertEquals(
            RobotError.CannotLookDown(0, SensorKind.SOUND),
            error(nxt.with(sensor(SensorKind.SOUND, Facing.Free, height = 2.0))),
        )
        val behind = Point(-10.0, 0.0)
        val ahead = sensor(SensorKind.ULTRASONIC, Facing.Ahead(0.0), at = behind)
        assertEquals("The ultrasonic sensor looks into the robot itself.", described(nxt.with(ahead)))
        assertEquals(emptyList(), robotErrors(nxt.with(ahead.copy(facing = Facing.Ahead(180.0)))))
        assertEquals(emptyList(), robotErrors(nxt.with(ahead.copy(height = 12.0))), "it looks over the robot")
        assertEquals(
            RobotError.FarAway(0, SensorKind.LIGHT, 26),
            error(rcx.with(sensor(SensorKind.LIGHT, Facing.Down, 1.0, at = Point(34.0, 0.0)))),
        )
        assertEquals("The bumper is inside the robot.", described(rcx.with(BumperPart(1, Point(3.0, 0.0), 4.0))))
    }

    @Test
    fun `figures out of their ranges`() {
        assertEquals("The mass must be from 0.1 to 5 kg.", described(rcx.chassis { copy(mass = 0.05) }))
        assertEquals("The track must be from 4 to 40 cm.", described(rcx.drive { copy(track = 41.0) }))
        assertEquals(
            "A direction must be from -360 to 360 degrees.",
            described(rcx.with(BumperPart(1, Point(9.0, 0.0), 4.0, direction = 400.0))),
        )
        assertEquals(RobotPiece.PART, error(rcx.with(BumperPart(1, Point(9.0, 0.0), 40.0))).piece)
        assertEquals(
            "The number of parts must be from 0 to 12.",
            described(
                rcx.copy(
                    parts = List(13) {
                        FingerTouchPart(null)
                    },
                ),
            ),
        )
    }
}
