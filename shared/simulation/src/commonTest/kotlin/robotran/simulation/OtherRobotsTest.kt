package robotran.simulation

import kotlinx.coroutines.test.runTest
import robotran.brick.controls.MotorPort
import robotran.brick.sensors.SensorKind
import robotran.language.Language
import robotran.rcxrom.state.RcxState
import robotran.robolang.RobolangResult
import robotran.robolang.compileRobolang
import robotran.robolang.messages.RobolangMessages
import robotran.robolang.robot.RobotTarget
import robotran.simulation.physics.loadPhysicsEngine
import robotran.simulation.state.GoalStatus
import robotran.world.BumperPart
import robotran.world.BumperSide
import robotran.world.Facing
import robotran.world.Goal
import robotran.world.GoalCondition.StayIn
import robotran.world.Lamp
import robotran.world.Mark
import robotran.world.MarkFigure
import robotran.world.ReadyRobots
import robotran.world.RobotDescription
import robotran.world.RotationPart
import robotran.world.SensorPart
import robotran.world.Wall
import robotran.world.World
import robotran.world.file.BuiltInWorlds
import robotran.world.geometry.Point
import robotran.world.geometry.Pose
import robotran.world.geometry.Shape
import robotran.world.robot.RobotParameters
import robotran.world.robot.robotErrors
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertFalse
import kotlin.test.assertTrue

/** Robots of other shapes drive, touch and see by their descriptions. */
class OtherRobotsTest {
    private val penbot = ReadyRobots.RCX_PENBOT
    private val plain = BuiltInWorlds.plain

    private fun World.with(robot: RobotDescription): World {
        assertEquals(emptyList(), robotErrors(robot))
        return copy(robots = robots.map { it.copy(description = robot) })
    }

    private suspend fun run(program: String, world: World): Session {
        val parameters = RobotParameters.of(world.robots.first().description)
        val target = RobotTarget.Rcx(parameters.millisecondsPerCentimetre, parameters.millisecondsPerDegree)
        val ready = compileRobolang(
            "test",
            program,
            target,
            messages = RobolangMessages.of(Language.ENGLISH),
        ) as RobolangResult.Success
        return Session(
            world,
            listOf(RobotProgramSet(listOf(ready.program))),
            loadPhysicsEngine(),
            Language.ENGLISH,
        ).apply {
            runUnattended(30_000)
        }
    }

    private val racer = penbot.copy(
        chassis = penbot.chassis.copy(
            outline = listOf(Point(-4.0, -4.0), Point(6.0, -4.0), Point(12.0, 0.0), Point(6.0, 4.0), Point(-4.0, 4.0)),
            mass = 0.9,
        ),
        drive = penbot.drive.copy(wheelDiameter = 7.0, track = 15.0, gear = 4.0),
        parts = emptyList(),
    )

    @Test
    fun `a robot with other wheels drives and turns as far as it is told`() = runTest {
        val driven = run("forward 30", plain.with(racer)).state.robot.pose
        assertEquals(plain.start.x + 30, driven.x, 0.3)
        assertEquals(plain.start.y, driven.y, 0.1)
        val turned = run("turn left 90", plain.with(racer)).state.robot.pose
        assertEquals(plain.start.heading + 90, turned.heading, 1.0)
    }

    @Test
    fun `a robot stops at a wall with its own outline`() = runTest {
        val pose = run("forward 150", plain.with(racer)).state.robot.pose
        assertEquals(plain.paper.width - 12.0, pose.x, 0.2)
    }

    @Test
    fun `the fastest robot does not get through a thin wall`() = runTest {
        val fast = penbot.copy(drive = penbot.drive.copy(wheelDiameter = 5.0, gear = 1.5), parts = emptyList())
        assertEquals(59.0, RobotParameters.of(fast).topSpeed, 1.0)
        val wall = Wall(Point(90.0, 0.0), Point(90.0, 80.0), thickness = 0.5)
        val world = plain.copy(walls = plain.walls + wall).withStart(Pose(20.0, 40.0, 0.0)).with(fast)
        val program = ScriptedProgram {
            motors(ScriptedProgram.FORWARD, 7)
            pause(5_000)
        }
        val session = startRun(program, world)
        repeat(4_000) {
            session.advance(1)
            val front = session.state.robot.pose.x + 8.0
            assertTrue(front < 89.75 + 0.2, "the front is at $front after ${session.state.milliseconds} ms")
        }
    }

    @Test
    fun `a dented outline is as solid as any other`() = runTest {
        val fork = penbot.copy(
            chassis = penbot.chassis.copy(
                outline = listOf(
                    Point(-5.0, -5.0),
                    Point(12.0, -5.0),
                    Point(3.0, 0.0),
                    Point(12.0, 5.0),
                    Point(-5.0, 5.0),
                ),
            ),
            parts = emptyList(),
        )
        val pose = run("forward 150", plain.with(fork)).state.robot.pose
        assertEquals(plain.paper.width - 12.0, pose.x, 0.2)
    }

    @Test
    fun `a bumper at the back is pressed from behind`() = runTest {
        val back = BumperPart(2, Point(-6.0, 0.0), width = 8.0, direction = 180.0)
        val session = run("backward 120", plain.with(penbot.copy(parts = listOf(back))))
        assertEquals(1, session.state.bumps)
        assertEquals(setOf(0), session.state.robot.pressed)
        assertTrue(session.state.brick.inputs[1].isPressed)
        assertFalse(session.state.brick.inputs[0].isPressed)
        assertFalse(session.state.robot.leftBumperPressed)
        assertEquals(6.0, session.state.robot.pose.x, 0.2)
    }

    @Test
    fun `two light sensors see two things`() = runTest {
        fun light(port: Int, y: Double) = SensorPart(port, SensorKind.LIGHT, Point(7.0, y), 1.0, Facing.Down)
        val robot = penbot.copy(parts = listOf(light(1, 2.0), light(3, -2.0)))
        val start = plain.start
        val black = Mark(MarkFigure.Area(Shape.Rectangle(Point(start.x + 7.0, start.y + 2.0), 3.0, 3.0)))
        val world = plain.copy(marks = listOf(black)).withStart(start.copy(heading = 0.0)).with(robot)
        val program = ScriptedProgram {
            activate(port = 0)
            activate(port = 2)
            pause(500)
        }
        val session = Session(world, listOf(program), loadPhysicsEngine(), Language.ENGLISH)
        session.pressRun()
        session.advance(300)
        val values = (session.state.brick as RcxState).sensors.map { it.raw }
        assertTrue(values[0] > values[2] + 50, "$values")
    }

    @Test
    fun `a light sensor looks where it is turned to`() = runTest {
        fun raw(direction: Double, at: Pose) = suspend {
            val eye = SensorPart(2, SensorKind.LIGHT, Point(0.0, 0.0), 12.0, Facing.Ahead(direction))
            val world = plain.withStart(at).with(penbot.copy(parts = listOf(eye)))
                .copy(lamps = listOf(Lamp(Point(60.0, 70.0), brightness = 4.0)))
            val session = Session(world, listOf(ScriptedProgram { pause(500) }), loadPhysicsEngine(), Language.ENGLISH)
            session.pressRun()
            session.advance(300)
            (session.state.brick as RcxState).sensors[1].raw
        }
        val below = Pose(60.0, 30.0, 0.0)
        val left = raw(90.0, below)()
        assertTrue(left + 100 < raw(-90.0, below)(), "the lamp is on its left")
        assertEquals(left, raw(0.0, below.copy(heading = 90.0))(), "turning the sensor is like turning the robot")
    }

    @Test
    fun `motors drive the wheels that they are mounted on`() = runTest {
        val crossed = penbot.drive.copy(left = MotorPort.C, right = MotorPort.A)
        val turned = run("turn left 90", plain.with(penbot.copy(drive = crossed))).state.robot.pose
        assertEquals(plain.start.heading - 90, turned.heading, 1.0)
        val reversed = run("forward 20", plain.with(penbot.copy(drive = penbot.drive.copy(reversed = true))))
        assertEquals(plain.start.x - 20, reversed.state.robot.pose.x, 0.3)
    }

    @Test
    fun `a robot without a pen draws nothing`() = runTest {
        val session = run("pen down\nforward 20", plain.with(penbot.copy(pen = null)))
        assertEquals(0.0, session.state.ink.lengthCentimetres)
        assertTrue(run("pen down\nforward 20", plain.with(penbot)).state.ink.lengthCentimetres > 15)
    }

    @Test
    fun `a rotation sensor counts the turns of its own wheel`() = runTest {
        val robot = racer.copy(parts = listOf(RotationPart(1, BumperSide.RIGHT)))
        val session = run("forward 44", plain.with(robot))
        val turns = session.state.robot.rightWheelTurn
        assertEquals(44 / (kotlin.math.PI * 7.0), turns, 0.05)
    }

    @Test
    fun `all of a robot is its own footprint`() = runTest {
        val region = Shape.Rectangle(Point(plain.start.x + 3.0, plain.start.y), 22.0, 20.0)
        val stay = plain.copy(goals = listOf(Goal(StayIn(region, whole = true))))
        val small = Session(stay, emptyList<RobotProgramSet>(), loadPhysicsEngine(), Language.ENGLISH).apply {
            finish()
        }
        val wide = racer.copy(drive = racer.drive.copy(track = 19.0))
        val large = Session(
            stay.with(wide),
            emptyList<RobotProgramSet>(),
            loadPhysicsEngine(),
            Language.ENGLISH,
        ).apply {
            finish()
        }
        assertTrue(small.state.goals.single().status == GoalStatus.MET)
        assertFalse(large.state.goals.single().status == GoalStatus.MET)
    }
}
