package robotran.ui.sheet

import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.geometry.Rect
import robotran.brick.controls.MotorMode
import robotran.brick.controls.MotorPort
import robotran.world.BrickMount
import robotran.world.ReadyRobots
import robotran.world.RobotDescription
import robotran.world.geometry.Point
import kotlin.math.abs
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertFalse
import kotlin.test.assertTrue

class RobotPlanTest {
    private val penbot = RobotPlan(ReadyRobots.RCX_PENBOT)

    @Test
    fun `the penbot's parts are where they were before robots were data`() {
        assertNear(Rect(1.5f, -4.9f, 7.6f, 4.9f), penbot.brick.box)
        assertNear(Rect(3.6f, -1.5f, 5.6f, 1.5f), penbot.brick.display)
        assertNear(Rect(8.2f, -6.6f, 9.2f, -0.2f), penbot.bumpers[0].barAt(0f))
        assertNear(Rect(8.2f, 0.2f, 9.2f, 6.6f), penbot.bumpers[1].barAt(0f))
        assertNear(Rect(7.5f, -3.7f, 8.4f, -3.1f), penbot.bumpers[0].armAt(0f))
        assertNear(Rect(6.8f, -0.8f, 8f, 0.8f), penbot.sensors.single().box)
        assertNear(Rect(-4.6f, -3.8f, -1.9f, -0.5f), penbot.motors[0].body)
        assertEquals(listOf(-2.25f, 2.25f), penbot.eyes.map { it.y })
        assertEquals(7.3f, penbot.eyes[0].x, NEAR)
        assertTrue(penbot.isBox)
    }

    @Test
    fun `no brick lies over the pen, and no sensor over an eye`() {
        for ((name, robot) in ReadyRobots.all) {
            val plan = RobotPlan(robot)
            if (plan.hasPen) assertFalse(plan.brick.box.contains(RobotPlan.PEN), name)
            for (eye in plan.eyes) {
                val tile = Rect(eye, RobotPlan.EYE_RADIUS)
                assertTrue(plan.sensors.none { it.box.overlaps(tile) }, "$name: $eye")
                // A board is hardly wider than a sonar: there the eyes stand beside it, on the buggy.
                val below = if (robot.brick.isOnBuggy) chassisOf(robot) else plan.brick.box
                assertTrue(below.overlaps(tile), name)
            }
        }
    }

    @Test
    fun `the upper end of a brick is ahead, or to the left of one that lies across`() {
        val along = RobotPlan(ReadyRobots.SUMO).brick
        assertTrue(along.rect(NxtLook.motorPorts[1]).center.x > along.display.center.x)
        val across = RobotPlan(ReadyRobots.NXT_PENBOT).brick
        assertTrue(across.rect(NxtLook.motorPorts[1]).center.y < across.display.center.y)
        val turned = RobotPlan(ReadyRobots.SUMO.copy(brickAt = BrickMount(Point(0.0, 0.0), turned = true))).brick
        assertTrue(turned.rect(NxtLook.motorPorts[1]).center.x < turned.display.center.x)
    }

    @Test
    fun `a bumper behind is drawn behind`() {
        val bumper = RobotPlan(ReadyRobots.SUMO).bumpers.single()
        assertTrue(bumper.corners.all { it.x < -8f })
        assertEquals(10f, bumper.corners.maxOf { it.y } - bumper.corners.minOf { it.y }, NEAR)
    }

    @Test
    fun `the eyes look where the motors of the wheels drive`() {
        val drive = ReadyRobots.RCX_PENBOT.drive.copy(left = MotorPort.B)
        val resting = SheetScenes.state(SheetScenes.everything)
        val motors = resting.robots.first().brick.motors.map {
            it.copy(mode = if (it.port == MotorPort.A) it.mode else MotorMode.FORWARD)
        }
        val brick = resting.robots.first().brick.let { brick -> brick.withRun(motors.map { it.mode }, brick.run) }
        val state = resting.copy(robots = listOf(resting.robots.first().copy(brick = brick)) + resting.robots.drop(1))
        assertEquals(Offset(1f, 0f), penbotFace(state, 0, drive = drive).gaze)
        assertEquals(
            Offset(-1f, 0f),
            penbotFace(state, 0, drive = drive.copy(reversed = true)).gaze.let {
                Offset(it.x, abs(it.y))
            },
        )
        assertEquals(Offset(0.5f, -0.5f), penbotFace(state, 0).gaze)
    }

    private fun assertNear(expected: Rect, actual: Rect) {
        assertEquals(expected.left, actual.left, NEAR)
        assertEquals(expected.top, actual.top, NEAR)
        assertEquals(expected.right, actual.right, NEAR)
        assertEquals(expected.bottom, actual.bottom, NEAR)
    }

    private companion object {
        const val NEAR = 1e-4f
    }

    private fun chassisOf(robot: RobotDescription): Rect {
        val (x, y) = robot.chassis.outline.map { it.x.toFloat() } to robot.chassis.outline.map { it.y.toFloat() }
        return Rect(x.min(), y.min(), x.max(), y.max())
    }
}
