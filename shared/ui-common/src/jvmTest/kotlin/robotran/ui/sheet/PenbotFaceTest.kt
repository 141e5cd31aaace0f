package robotran.ui.sheet

import androidx.compose.ui.geometry.Offset
import robotran.brick.controls.MotorMode
import robotran.brick.state.RunState
import robotran.simulation.state.GoalStatus
import robotran.simulation.state.RobotSnapshot
import robotran.simulation.state.SessionState
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertNotEquals
import kotlin.test.assertTrue

class PenbotFaceTest {
    private val resting = SheetScenes.state(SheetScenes.everything)

    @Test
    fun `a robot that stands looks up`() = assertEquals(Offset.Zero, penbotFace(resting, 0).gaze)

    @Test
    fun `it looks where it drives`() {
        assertEquals(Offset(1f, 0f), gaze(MotorMode.FORWARD, MotorMode.FORWARD))
        assertEquals(Offset(-1f, 0f), gaze(MotorMode.BACKWARD, MotorMode.BACKWARD))
    }

    @Test
    fun `it looks into a turn`() {
        assertEquals(Offset(0f, -1f), gaze(left = MotorMode.BACKWARD, right = MotorMode.FORWARD))
        assertEquals(Offset(0f, 1f), gaze(left = MotorMode.FORWARD, right = MotorMode.BACKWARD))
        assertTrue(gaze(left = MotorMode.FORWARD, right = MotorMode.FLOAT).run { x > 0 && y > 0 })
    }

    @Test
    fun `it sulks for a while after a bump, and then no longer`() {
        val bumped = resting.with { copy(bumps = 1, bumpedAt = 5_000) }
        assertEquals(PenbotMood.SULKING, penbotMood(bumped.copy(milliseconds = 5_000), 0))
        assertEquals(PenbotMood.SULKING, penbotMood(bumped.copy(milliseconds = 6_000), 0))
        assertEquals(PenbotMood.CALM, penbotMood(bumped.copy(milliseconds = 7_000), 0))
        assertEquals(PenbotMood.CALM, penbotMood(bumped.copy(milliseconds = 5_000), 1))
    }

    @Test
    fun `it is glad once all goals are met, even if it has just bumped`() {
        val met = resting.copy(goals = listOf(SheetScenes.progress(GoalStatus.MET)))
        assertEquals(PenbotMood.GLAD, penbotMood(met.with { copy(bumpedAt = 0) }, 0))
        val half = met.copy(goals = met.goals + SheetScenes.progress(GoalStatus.PENDING))
        assertEquals(PenbotMood.CALM, penbotMood(half, 0))
        assertEquals(PenbotMood.CALM, penbotMood(resting, 0))
    }

    @Test
    fun `it blinks seldom and shortly, and not at the same time as others`() {
        val running = resting.with { copy(brick = brick.withRun(brick.motors.map { it.mode }, RunState.Running(1))) }
        val blinks = List(2) { robot ->
            (0L until A_MINUTE).filter { penbotFace(running.copy(milliseconds = it), robot).lid > 0 }
        }
        for (each in blinks) {
            val times = each.filter { it - 1 !in each }
            assertTrue(times.size in 8..14, "$times")
            assertTrue(each.size < A_MINUTE / 30)
        }
        assertTrue(blinks[0].none { it in blinks[1] })
    }

    @Test
    fun `eyes are open while nothing runs`() =
        assertTrue((0L until A_MINUTE).none { penbotFace(resting.copy(milliseconds = it), 0).lid > 0 })

    @Test
    fun `with less motion nothing about it changes`() {
        val met = resting.copy(goals = listOf(SheetScenes.progress(GoalStatus.MET)))
        assertNotEquals(PenbotFace.STILL, penbotFace(met, 0))
        assertEquals(PenbotFace.STILL, penbotFace(met, 0, isStill = true))
    }

    private fun gaze(left: MotorMode, right: MotorMode): Offset {
        val modes = listOf(left, MotorMode.FLOAT, right)
        return penbotFace(resting.with { copy(brick = brick.withRun(modes, brick.run)) }, 0).gaze
    }

    /** With a change of the first robot, and the second one as it is but for its brick. */
    private fun SessionState.with(change: RobotSnapshot.() -> RobotSnapshot): SessionState {
        val first = robots[0].change()
        return copy(robots = listOf(first, robots[1].copy(brick = first.brick)))
    }

    private companion object {
        const val A_MINUTE = 60_000L
    }
}
