package robotran.simulation

import io.kotest.core.spec.style.StringSpec
import io.kotest.matchers.doubles.shouldBeGreaterThan
import io.kotest.matchers.doubles.shouldBeLessThan
import io.kotest.matchers.ints.shouldBeGreaterThan
import io.kotest.matchers.shouldBe
import io.kotest.property.Arb
import io.kotest.property.arbitrary.double
import io.kotest.property.arbitrary.int
import io.kotest.property.checkAll
import robotran.brick.kind.BrickKind
import robotran.brick.program.BrickProgram
import robotran.simulation.nxt.ScriptedNxt
import robotran.simulation.physics.loadPhysicsEngine
import robotran.world.Block
import robotran.world.Paper
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
import robotran.world.robot.robotErrors

/**
 * A robot described at random is refused in a sentence, or is the same after it has been written and read, and drives
 * for a minute among walls without harm.
 */
class RobotProperties :
    StringSpec({
        fun wall(fromX: Double, fromY: Double, toX: Double, toY: Double) =
            Wall(Point(fromX, fromY), Point(toX, toY), thickness = 0.5)
        val pen = listOf(
            wall(0.0, 0.0, 200.0, 0.0),
            wall(200.0, 0.0, 200.0, 200.0),
            wall(200.0, 200.0, 0.0, 200.0),
            wall(0.0, 200.0, 0.0, 0.0),
        )
        val driving = ScriptedProgram {
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

        val drivingNxt = ScriptedNxt {
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

        suspend fun check(brick: BrickKind, program: BrickProgram, times: Int) {
            val physics = loadPhysicsEngine()
            var driven = 0
            checkAll(times, arbitraryRobots(brick), Arb.double(-180.0, 180.0), Arb.int(0..3)) {
                robot,
                heading,
                noise,
                ->
                val read = readRobot(writeRobot(robot))
                if (robotErrors(robot).isNotEmpty()) {
                    (read as RobotFileResult.Rejected).message.trim().endsWith(".") shouldBe true
                    return@checkAll
                }
                read shouldBe RobotFileResult.Loaded(robot)
                driven++
                val world = World(
                    "A pen",
                    Paper(200.0, 200.0),
                    listOf(RobotPlacement(Pose(100.0, 100.0, heading), description = robot)),
                    walls = pen,
                    blocks = listOf(Block(Shape.Rectangle(Point(40.0, 40.0), 10.0, 10.0), mass = 0.2)),
                    realism = noise / 3.0,
                )
                val session = Session(world, listOf(program), physics)
                session.pressRun()
                repeat(120) {
                    session.advance(500)
                    val pose = session.state.robot.pose
                    // The wall is thinner than the robot, so its middle stays inside unless it has gone through.
                    pose.x shouldBeGreaterThan 0.0
                    pose.x shouldBeLessThan 200.0
                    pose.y shouldBeGreaterThan 0.0
                    pose.y shouldBeLessThan 200.0
                    pose.heading.isFinite() shouldBe true
                }
                session.close()
            }
            driven shouldBeGreaterThan 20
        }

        "a random robot with an RCX is refused, or drives for a minute without leaving its pen" {
            check(BrickKind.RCX, driving, times = 120)
        }

        "so is or does one with an NXT" {
            check(BrickKind.NXT, drivingNxt, times = 100)
        }
    })
