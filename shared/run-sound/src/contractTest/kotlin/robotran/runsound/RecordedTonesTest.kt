package robotran.runsound

import kotlinx.coroutines.test.runTest
import robotran.world.Goal
import robotran.world.GoalCondition.Reach
import robotran.world.geometry.Point
import robotran.world.geometry.Shape
import kotlin.test.Test
import kotlin.test.assertEquals

/** The same run sounds the same on every platform, bit for bit. */
class RecordedTonesTest {
    @Test
    fun `a drive over a line, past a goal, round a corner and against a wall has the recorded tones`() = runTest {
        val world = plain().withStrip(33.0).withBox(66.0)
            .copy(goals = listOf(Goal(Reach(Shape.Circle(Point(30.0, 40.0), 3.0)))))
        val tones = heard(DRIVE, 5_000, world)
        assertEquals(RECORDED_TONES.trim(), tones.joinToString("\n") { it.line() })
    }

    private companion object {
        const val DRIVE =
            "pen down\nforward 8\nbackward 2\nturn left 20\nturn right 20\nbeep\nstart forward\nwait 2 seconds"
    }
}
