package robotran.simulation

import io.kotest.core.spec.style.StringSpec
import io.kotest.matchers.doubles.shouldBeGreaterThan
import io.kotest.matchers.doubles.shouldBeLessThan
import io.kotest.matchers.ints.shouldBeGreaterThan
import io.kotest.matchers.shouldBe
import io.kotest.property.Arb
import io.kotest.property.arbitrary.boolean
import io.kotest.property.arbitrary.choice
import io.kotest.property.arbitrary.double
import io.kotest.property.arbitrary.element
import io.kotest.property.arbitrary.int
import io.kotest.property.checkAll
import robotran.brick.kind.BrickKind
import robotran.brick.program.BrickProgram
import robotran.brick.state.RunState
import robotran.hub.model.HubModel
import robotran.language.Language
import robotran.language.fuzz.Fuzzing
import robotran.microbit.model.MicrobitModel
import robotran.robolang.RobolangResult
import robotran.robolang.compileRobolang
import robotran.robolang.messages.RobolangMessages
import robotran.robolang.robot.RobotTarget
import robotran.simulation.hub.hubSensors
import robotran.simulation.microbit.buggyWiring
import robotran.simulation.microbit.microbitSensors
import robotran.simulation.nxt.ScriptedNxt
import robotran.simulation.physics.PhysicsEngine
import robotran.simulation.physics.loadPhysicsEngine
import robotran.world.MovableBlock
import robotran.world.Paper
import robotran.world.ReadyRobots
import robotran.world.RobotDescription
import robotran.world.RobotPlacement
import robotran.world.Wall
import robotran.world.World
import robotran.world.file.RobotFileResult
import robotran.world.file.arbitraryRobots
import robotran.world.file.readRobot
import robotran.world.file.writeRobot
import robotran.world.geometry.Point
import robotran.world.geometry.Pose
import robotran.world.geometry.Shape
import robotran.world.robot.RobotParameters
import robotran.world.robot.robotErrors
import kotlin.math.hypot

/**
 * A robot described at random is refused in a sentence, or is the same after it has been written and read, and drives
 * for a minute among walls without harm.
 */
class RobotProperties :
    StringSpec({
        suspend fun check(brick: BrickKind, scripted: BrickProgram, times: Int) {
            val physics = loadPhysicsEngine()
            var driven = 0
            var moved = 0
            checkAll(times, arbitraryRobots(brick), Arb.int(-180..180), Arb.int(0..3), Arb.boolean()) {
                robot,
                heading,
                noise,
                isScripted,
                ->
                val read = readRobot(writeRobot(robot), Language.ENGLISH)
                if (robotErrors(robot).isNotEmpty()) {
                    (read as RobotFileResult.Failure).message.trim().endsWith(".") shouldBe true
                    return@checkAll
                }
                read shouldBe RobotFileResult.Success(robot)
                driven++
                val program = if (isScripted) scripted else programFor(robot)
                if (DriveInPen(robot, heading.toDouble(), noise / 3.0, program, physics).letDrive(MINUTE) > 1) moved++
            }
            driven shouldBeGreaterThan times / 10
            moved shouldBeGreaterThan driven * 9 / 10
        }

        "a random robot with an RCX is refused, or drives for a minute without leaving its pen" {
            check(BrickKind.RCX, scriptedRcx, times = Fuzzing.share(180, atLeast = 20))
        }

        "so is or does one with an NXT" {
            check(BrickKind.NXT, scriptedNxt, times = Fuzzing.share(150, atLeast = 20))
        }

        "a robot whose file was damaged is refused, or drives" {
            val physics = loadPhysicsEngine()
            val robots = Arb.element(ReadyRobots.all.values.toList())
            val factors = Arb.choice(Arb.double(0.5, 1.5), Arb.double(-3.0, 3.0))
            val others = Arb.element(
                "null",
                "0",
                "1",
                "3",
                "12",
                "\"A\"",
                "\"B\"",
                "\"down\"",
                "\"light\"",
                "true",
                "[]",
            )
            var driven = 0
            val times = Fuzzing.share(600, atLeast = 60)
            checkAll(times, robots, Arb.int(0..10_000), factors, others) { ready, place, factor, other ->
                val whole = writeRobot(ready.copy(base = null))
                val values = VALUE.findAll(whole).filter { whole[it.range.last + 1] != ':' }.toList()
                val value = values[place % values.size]
                // Most figures change somewhat, so that many robots can still be built.
                val damaged = value.value.toDoubleOrNull()?.let { "${(it * factor * 1000).toInt() / 1000.0}" } ?: other
                val read = readRobot(whole.replaceRange(value.range, damaged), Language.ENGLISH)
                val robot = (read as? RobotFileResult.Success)?.robot ?: return@checkAll
                driven++
                DriveInPen(robot, heading = 30.0, realism = 1.0, programFor(robot), physics).letDrive(SECONDS)
            }
            driven shouldBeGreaterThan times / 10
        }
    })

/** A robot in a pen with a block. */
private class DriveInPen(
    robot: RobotDescription,
    heading: Double,
    realism: Double,
    program: BrickProgram,
    physics: PhysicsEngine,
) {
    private val world = World(
        "A pen",
        Paper(200.0, 200.0),
        listOf(RobotPlacement(Pose(100.0, 100.0, heading), description = robot)),
        walls = PEN,
        blocks = listOf(MovableBlock(Shape.Rectangle(Point(40.0, 40.0), 10.0, 10.0), mass = 0.2)),
        realism = realism,
    )
    private val session = Session(world, listOf(program), physics, Language.ENGLISH)

    /** Lets the robot drive, checks it all the time, and returns how far it has come, in centimetres. */
    fun letDrive(milliseconds: Int): Double {
        session.pressRun()
        var way = 0.0
        var before = session.state.robot.pose
        repeat(milliseconds / LOOK) {
            session.advance(LOOK)
            val pose = session.state.robot.pose
            // The wall is thinner than the robot, so its middle stays inside unless it has gone through.
            for (coordinate in listOf(pose.x, pose.y)) {
                coordinate shouldBeGreaterThan 0.0
                coordinate shouldBeLessThan 200.0
            }
            pose.heading.isFinite() shouldBe true
            way += hypot(pose.x - before.x, pose.y - before.y)
            before = pose
        }
        (session.state.brick.run is RunState.Failed) shouldBe false
        // JSON has no number that is not finite.
        session.report().toJson().isNotEmpty() shouldBe true
        session.close()
        return way
    }
}

/** Drives by the robot's own motors, and reads what it has. */
private fun programFor(robot: RobotDescription): BrickProgram {
    val nxt = if (robot.brick == BrickKind.NXT) "  show distance\n  show turned A\n" else ""
    val pen = if (robot.pen == null) "" else "pen down\n"
    val text =
        "${pen}repeat 5 times\n  forward 40\n  turn left 100\n  show light\n$nxt  backward 25\n  turn right 30\n" +
            "  power 7\n  start forward\n  wait 2 seconds\n  stop\n  power 3\nend\n"
    return (
        compileRobolang(
            "random",
            text,
            targetOf(robot),
            messages = RobolangMessages.of(Language.ENGLISH),
        ) as RobolangResult.Success
    ).program
}

private fun targetOf(robot: RobotDescription): RobotTarget = with(robot.drive) {
    when (robot.brick) {
        BrickKind.RCX -> RobotParameters.of(robot).let {
            val (centimetre, degree) = it.millisecondsPerCentimetre to it.millisecondsPerDegree
            RobotTarget.Rcx(centimetre, degree, left, right, robot.pen?.motor, reversed)
        }

        BrickKind.NXT -> RobotTarget.Nxt(wheelDiameter / gear, track, left, right, robot.pen?.motor, reversed)

        BrickKind.MICROBIT, BrickKind.MICROBIT_V1 -> RobotParameters.of(robot).let {
            RobotTarget.Microbit(
                checkNotNull(MicrobitModel.of(robot.brick)),
                checkNotNull(robot.buggyWiring),
                it.millisecondsPerCentimetre,
                it.millisecondsPerDegree,
                left,
                right,
                robot.pen?.motor,
                reversed,
                checkNotNull(robot.buggy).trim,
                robot.microbitSensors,
            )
        }

        else -> RobotTarget.Hub(
            checkNotNull(HubModel.of(robot.brick)),
            10 * wheelDiameter / gear,
            10 * track,
            left,
            right,
            robot.pen?.motor,
            reversed,
            robot.hubSensors,
        )
    }
}

private val scriptedRcx = ScriptedProgram {
    for (port in 0..2) activate(port)
    penDown()
    repeat(6) {
        motors(ScriptedProgram.FORWARD, 7)
        pause(4_000)
        motors(ScriptedProgram.BACKWARD, 7)
        pause(3_000)
        turnLeft(100.0)
        motors(ScriptedProgram.FLOAT, 3)
        pause(1_000)
    }
}

private val scriptedNxt = ScriptedNxt {
    for (port in 1..4) sonar(port)
    repeat(6) {
        regulate(ScriptedNxt.A, ScriptedNxt.B, ScriptedNxt.C, speed = 700f)
        pause(4_000)
        motors(-100, -100, brakes = false)
        pause(3_000)
        motors(-50, 50)
        pause(1_000)
        motors(0, 0, brakes = false)
        pause(1_000)
    }
}

private val PEN = listOf(
    wall(0.0, 0.0, 200.0, 0.0),
    wall(200.0, 0.0, 200.0, 200.0),
    wall(200.0, 200.0, 0.0, 200.0),
    wall(0.0, 200.0, 0.0, 0.0),
)

private fun wall(fromX: Double, fromY: Double, toX: Double, toY: Double) =
    Wall(Point(fromX, fromY), Point(toX, toY), thickness = 0.5)

/** A number, text, truth value or null of a file, or the name of a field. */
private val VALUE = Regex("\"[^\"]*\"|-?[0-9.]+|true|false|null")

private const val MINUTE = 60_000
private const val SECONDS = 10_000

/** Milliseconds between two looks. */
private const val LOOK = 500
