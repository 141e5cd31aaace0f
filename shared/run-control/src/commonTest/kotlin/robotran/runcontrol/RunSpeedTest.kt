package robotran.runcontrol

import kotlinx.coroutines.test.runTest
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertNotEquals
import kotlin.test.assertTrue

class RunSpeedTest {
    private suspend fun timeAfterASecond(speed: RunSpeed): Long {
        val player = started(BUSY)
        player.speed = speed
        player.frames(101, milliseconds = 10)
        return player.time
    }

    @Test
    fun `a second on the screen is as much virtual time as the speed says`() = runTest {
        assertEquals(100, timeAfterASecond(RunSpeed.TENTH))
        assertEquals(250, timeAfterASecond(RunSpeed.QUARTER))
        assertEquals(500, timeAfterASecond(RunSpeed.HALF))
        assertEquals(1_000, timeAfterASecond(RunSpeed.REAL_TIME))
        assertEquals(2_000, timeAfterASecond(RunSpeed.DOUBLE))
        assertEquals(5_000, timeAfterASecond(RunSpeed.FIVEFOLD))
        assertEquals(10_000, timeAfterASecond(RunSpeed.TENFOLD))
    }

    @Test
    fun `as fast as it goes asks for more while frames come in time, and for less when they are late`() = runTest {
        val pace = FramePace()

        fun frames(from: Long, milliseconds: Long) = List(20) {
            pace.millisecondsTo((from + it * milliseconds) * 1_000_000, RunSpeed.FASTEST)
        }
        val quick = frames(0, 16)
        assertTrue(quick.last() > quick[1] && quick.last() <= 5_000, "$quick")
        val late = frames(320, 60)
        assertTrue(late.last() < late.first(), "$late")
        assertTrue(late.all { it >= 100 }, "$late")
    }

    /**
     * The median request and the max duration of the last 50 of 200 frames, if [cost] gives the real milliseconds of a
     * frame.
     */
    private fun settled(cost: (Int) -> Int): Pair<Int, Int> {
        val pace = FramePace()
        var now = 0L
        val frames = List(200) {
            val asked = pace.millisecondsTo(now * 1_000_000, RunSpeed.FASTEST)
            val took = cost(asked)
            now += took
            asked to took
        }.takeLast(50)
        return frames.map { it.first }.sorted()[25] to frames.maxOf { it.second }
    }

    @Test
    fun `as fast as it goes is as fast as that where frames are drawn slowly`() {
        val (asked, longest) = settled { 60 + it / 50 }
        assertTrue(asked >= 1_000, "$asked virtual milliseconds in a frame")
        assertTrue(longest <= 120, "$longest real milliseconds for a frame")
    }

    @Test
    fun `as fast as it goes leaves time for drawing where computing is slow`() {
        val (asked, longest) = settled { maxOf(16, 4 + it / 20) }
        assertTrue(asked >= 300, "$asked virtual milliseconds in a frame")
        assertTrue(longest <= 45, "$longest real milliseconds for a frame")
    }

    @Test
    fun `a screen with ten frames a second shows real time`() = runTest {
        val player = started(BUSY)
        player.frames(11, milliseconds = 100)
        assertEquals(1_000, player.time)
    }

    @Test
    fun `a screen that was not drawn for long does not make up for it`() = runTest {
        val player = started(BUSY)
        player.frame(0)
        player.frame(10_000_000_000)
        assertEquals(100, player.time)
    }

    @Test
    fun `the speed makes no difference to the run`() = runTest {
        val hashes = RunSpeed.entries.map { speed ->
            val player = started(BUSY)
            player.speed = speed
            player.frames(400)
            player.seek(500)
            player.finishSeeking()
            player.session.traceHash
        }
        assertEquals(1, hashes.toSet().size, "$hashes")
    }

    @Test
    fun `in slow motion the robot is drawn between the steps of the physics`() = runTest {
        val player = started("forward 30")
        player.pass(500)
        player.speed = RunSpeed.TENTH
        val next = player.frames(30)
        val drawn = mutableListOf<Double>()
        repeat(12) {
            player.frames(1, from = next + it * 16)
            drawn += player.drawn.robot.pose.x
            assertNotEquals(0.0, player.state.robot.pose.x)
        }
        assertEquals(12, drawn.toSet().size, "$drawn")
        assertEquals(drawn.sorted(), drawn)
        player.pause()
        assertEquals(player.state, player.drawn)
    }
}
