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
import robotran.simulation.physics.loadPhysicsEngine
import robotran.world.Block
import robotran.world.Paper
import robotran.world.RobotPlacement
import robotran.world.Wall
import robotran.world.World
import robotran.world.file.arbitraryRobots
import robotran.world.geometry.Point
import robotran.world.geometry.Pose
import robotran.world.geometry.Shape
import robotran.world.robot.robotErrors

/** A robot that is not refused drives for a minute among walls without harm. */
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

        "a random robot is refused, or drives for a minute without leaving its pen" {
            val physics = loadPhysicsEngine()
            var driven = 0
            checkAll(120, arbitraryRobots(BrickKind.RCX), Arb.double(-180.0, 180.0), Arb.int(0..3)) {
                robot,
                heading,
                noise,
                ->
                if (robotErrors(robot).isNotEmpty()) return@checkAll
                driven++
                val world = World(
                    "A pen",
                    Paper(200.0, 200.0),
                    listOf(RobotPlacement(Pose(100.0, 100.0, heading), description = robot)),
                    walls = pen,
                    blocks = listOf(Block(Shape.Rectangle(Point(40.0, 40.0), 10.0, 10.0), mass = 0.2)),
                    realism = noise / 3.0,
                )
                val session = Session(world, listOf(driving), physics)
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
            driven shouldBeGreaterThan 25
        }
    })
