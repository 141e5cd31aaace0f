package robotran.simulation.goal

import kotlinx.coroutines.test.runTest
import robotran.simulation.state.GoalStatus
import robotran.world.Goal
import robotran.world.GoalCondition.FollowLine
import robotran.world.Mark
import robotran.world.MarkFigure
import robotran.world.geometry.Point
import robotran.world.geometry.length
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertTrue

class FollowLineTest {
    private val square = listOf(10.0 to 10.0, 50.0 to 10.0, 50.0 to 50.0, 10.0 to 50.0)
    private val straight = listOf(10.0 to 10.0, 90.0 to 10.0)

    /** Two triangles with a common tip at 50, 30, where the line crosses itself. */
    private val eight = listOf(20.0 to 10.0, 80.0 to 50.0, 80.0 to 10.0, 20.0 to 50.0)

    private fun world(points: List<Pair<Double, Double>>, closed: Boolean) = sheet.copy(
        marks = listOf(
            Mark(
                MarkFigure.Line(points.map { Point(it.first, it.second) }, 2.0, closed),
                name = "line",
            ),
        ),
    )

    private suspend fun round(points: List<Pair<Double, Double>>, laps: Double = 1.0, within: Int? = null) =
        run(Goal(FollowLine("line", laps, within = within)), world = world(points, closed = true))

    private suspend fun along(points: List<Pair<Double, Double>>, laps: Double = 1.0) =
        run(Goal(FollowLine("line", laps)), world = world(points, closed = false))

    /** Moves the sensor through these points in steps of half a centimetre. */
    private fun Run.drive(vararg places: Pair<Double, Double>) = places.toList().zipWithNext { from, to ->
        val steps = (2 * length(to.first - from.first, to.second - from.second)).toInt() + 1
        for (step in 0..steps) {
            val share = step.toDouble() / steps
            sensorAt(from.first + share * (to.first - from.first), from.second + share * (to.second - from.second))
        }
    }

    private fun Run.drive(places: List<Pair<Double, Double>>) = drive(*places.toTypedArray())

    @Test
    fun `once round in either direction from anywhere`() = runTest {
        val way = listOf(30.0 to 10.0) + square.drop(1) + listOf(10.0 to 10.0, 30.0 to 10.0)
        for (direction in listOf(way, way.reversed())) {
            val run = round(square)
            run.drive(direction.take(3))
            assertTrue(run.goal.progress in 0.3..0.5, "${run.goal.progress}")
            run.drive(direction.drop(2))
            assertEquals(GoalStatus.MET, run.status)
        }
    }

    @Test
    fun `three quarters of the way are not once round`() = runTest {
        val run = round(square)
        run.drive(square)
        assertEquals(0.75, run.goal.progress, 0.03)
        run.finish()
        assertEquals(GoalStatus.FAILED, run.status)
    }

    @Test
    fun `to and fro is no way`() = runTest {
        val run = round(square)
        repeat(20) { run.drive(20.0 to 10.0, 45.0 to 10.0, 20.0 to 10.0) }
        assertTrue(run.goal.progress < 0.2, "${run.goal.progress}")
    }

    @Test
    fun `cutting corners within the tolerance and weaving is following`() = runTest {
        val run = round(square)
        run.drive(
            30.0 to 12.0,
            45.0 to 12.0,
            48.0 to 15.0,
            52.0 to 30.0,
            48.0 to 45.0,
            44.0 to 49.0,
            15.0 to 51.0,
            11.0 to 45.0,
            12.0 to 14.0,
            16.0 to 12.0,
            30.0 to 9.0,
        )
        assertEquals(GoalStatus.MET, run.status)
    }

    @Test
    fun `straight through the middle is no short cut`() = runTest {
        val run = round(square)
        repeat(5) { run.drive(30.0 to 10.0, 50.0 to 10.0, 50.0 to 50.0, 30.0 to 50.0, 30.0 to 10.0) }
        assertEquals(GoalStatus.PENDING, run.status)
        assertTrue(run.goal.progress < 0.6, "${run.goal.progress}")
    }

    @Test
    fun `who loses the line comes back where he has lost it`() = runTest {
        val run = round(square)
        run.drive(30.0 to 10.0, 40.0 to 10.0, 42.0 to 16.0, 45.0 to 10.0, 50.0 to 10.0)
        run.drive(square.drop(1) + listOf(10.0 to 10.0, 30.0 to 10.0))
        assertEquals(GoalStatus.MET, run.status)
    }

    @Test
    fun `rounds that are done stay done`() = runTest {
        val run = round(square, laps = 2.0)
        val once = square + listOf(10.0 to 10.0)
        run.drive(once)
        assertEquals(0.5, run.goal.progress, 0.03)
        run.drive(10.0 to 10.0, 30.0 to 30.0, 50.0 to 50.0)
        run.drive(50.0 to 50.0, 10.0 to 50.0, 10.0 to 10.0, 50.0 to 10.0)
        assertEquals(GoalStatus.PENDING, run.status)
        run.drive(50.0 to 10.0, 50.0 to 50.0)
        assertEquals(GoalStatus.MET, run.status)
    }

    @Test
    fun `a line that crosses itself is followed across the crossing`() = runTest {
        val run = round(eight)
        run.drive(eight)
        assertTrue(run.goal.progress in 0.7..0.9, "${run.goal.progress}")
        run.drive(20.0 to 50.0, 20.0 to 10.0)
        assertEquals(GoalStatus.MET, run.status)
    }

    @Test
    fun `who turns at the crossing has left the line`() = runTest {
        val run = round(eight)
        repeat(3) { run.drive(50.0 to 30.0, 80.0 to 50.0, 80.0 to 10.0, 50.0 to 30.0) }
        assertEquals(GoalStatus.PENDING, run.status)
    }

    @Test
    fun `an open line is followed from one end to the other`() = runTest {
        for (way in listOf(straight, straight.reversed())) {
            val run = along(straight)
            run.drive(way)
            assertEquals(GoalStatus.MET, run.status)
        }
        val fromTheMiddle = along(straight)
        fromTheMiddle.drive(50.0 to 10.0, 90.0 to 10.0)
        assertEquals(GoalStatus.PENDING, fromTheMiddle.status)
        fromTheMiddle.drive(90.0 to 10.0, 10.0 to 10.0)
        assertEquals(GoalStatus.MET, fromTheMiddle.status)
    }

    @Test
    fun `the robot may begin with its pen at the end`() = runTest {
        val run = along(straight)
        run.robotAt(10.0, 10.0)
        run.drive(17.2 to 10.0, 87.0 to 10.0)
        assertEquals(GoalStatus.MET, run.status)
    }

    @Test
    fun `twice along an open line is there and back, or there twice`() = runTest {
        val back = along(straight, laps = 2.0)
        back.drive(straight)
        assertEquals(0.5, back.goal.progress, 0.01)
        back.drive(straight.reversed())
        assertEquals(GoalStatus.MET, back.status)
        val again = along(straight, laps = 2.0)
        again.drive(10.0 to 10.0, 90.0 to 10.0, 90.0 to 40.0, 10.0 to 40.0, 10.0 to 10.0, 90.0 to 10.0)
        assertEquals(GoalStatus.MET, again.status)
    }

    @Test
    fun `beside the line nothing counts, nor too late`() = runTest {
        val beside = along(straight)
        beside.drive(10.0 to 15.0, 90.0 to 15.0)
        assertEquals(0.0, beside.goal.progress)
        val late = round(square, within = 3)
        late.until(3.5)
        assertEquals(GoalStatus.FAILED, late.status)
    }

    @Test
    fun `a line that is not there cannot be followed`() = runTest {
        val run = run(Goal(FollowLine("path")), world = world(square, closed = true))
        assertEquals(GoalStatus.FAILED, run.status)
    }

    @Test
    fun `repeated points are no trouble`() = runTest {
        val run = along(listOf(10.0 to 10.0, 10.0 to 10.0, 50.0 to 10.0, 50.0 to 10.0, 90.0 to 10.0))
        run.drive(straight)
        assertEquals(GoalStatus.MET, run.status)
    }
}
