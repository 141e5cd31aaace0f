package robotran.runsound

import kotlinx.coroutines.test.runTest
import robotran.simulation.SessionInput
import robotran.world.Goal
import robotran.world.GoalCondition.Reach
import robotran.world.GoalCondition.StayOut
import robotran.world.geometry.Point
import robotran.world.geometry.Pose
import robotran.world.geometry.Shape
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertNotNull
import kotlin.test.assertNull
import kotlin.test.assertTrue

class RunSoundTest {
    @Test
    fun `straight on both wheels tick in the middle, as often as they come round`() = runTest {
        val ticks = heard("start forward\nwait 3 seconds", 2_500).of(RunSign.WHEEL)
        assertTrue(ticks.size in 8..30, "$ticks")
        assertTrue(ticks.count { it.pan == 0.0 } > ticks.size / 2, "$ticks")
    }

    @Test
    fun `in a curve each wheel ticks in its own ear, the outer one more often`() = runTest {
        val ticks = heard("motor A power 1\nmotor C power 7\nstart forward\nwait 3 seconds", 3_000).of(RunSign.WHEEL)
        assertTrue(ticks.count { it.pan > 0 } > ticks.count { it.pan < 0 }, "$ticks")
    }

    @Test
    fun `backwards the ticks are an octave lower`() = runTest {
        val forwards = heard("start forward\nwait 1 second", 900).of(RunSign.WHEEL).map { it.hertz }.toSet()
        val backwards = heard("start backward\nwait 1 second", 900).of(RunSign.WHEEL).map { it.hertz * 2 }.toSet()
        assertTrue(backwards.isNotEmpty() && forwards.containsAll(backwards), "$forwards $backwards")
    }

    @Test
    fun `the nearer the wall, the higher the tone`() = runTest {
        val tones = heard("start forward\nwait 9 seconds", 4_000, plain().withBox(90.0)).of(RunSign.AHEAD)
        val pitches = tones.map { it.hertz }
        assertEquals(pitches.sorted(), pitches)
        assertTrue(pitches.toSet().size >= 6, "$pitches")
    }

    @Test
    fun `with nothing ahead the tone is the lowest`() = runTest {
        val tones = heard("start forward\nwait 2 seconds", 1_500).of(RunSign.AHEAD)
        assertEquals(setOf(SoundValues.PITCHES.last()), tones.map { it.hertz }.toSet())
    }

    @Test
    fun `the tone moves from ear to ear as the robot does over the sheet`() = runTest {
        val pans = heard("start forward\nwait 9 seconds", 4_000).of(RunSign.AHEAD).map { it.pan }
        assertEquals(pans.sorted(), pans)
        assertTrue(pans.first() < -0.3 && pans.last() > pans.first() + 0.3, "$pans")
    }

    @Test
    fun `a line is told at once by a sharp tone, and paper behind it by a soft one`() = runTest {
        val tones = heard("start forward\nwait 9 seconds", 4_000, plain().withStrip(45.0)).of(RunSign.AHEAD)
        val timbres = tones.map { it.timbre }
        val changes = timbres.filterIndexed { number, timbre -> number == 0 || timbre != timbres[number - 1] }
        assertEquals(listOf(Timbre.SINE, Timbre.SAWTOOTH, Timbre.SINE), changes)
    }

    @Test
    fun `ink sounds hollow`() = runTest {
        val source = "pen down\nforward 20\npen up\nbackward 30\nstart forward\nwait 9 seconds"
        val timbres = heard(source, 12_000).of(RunSign.AHEAD).map { it.timbre }.toSet()
        assertEquals(setOf(Timbre.SINE, Timbre.SQUARE), timbres)
    }

    @Test
    fun `a bump is a thud, and pushing on is no other one`() = runTest {
        val bumps = heard("start forward\nwait 9 seconds", 6_000, plain().withBox(60.0)).of(RunSign.BUMP)
        assertEquals(RunSign.BUMP.tones.map { it.hertz }, bumps.map { it.hertz })
    }

    @Test
    fun `goals reached and lost have signs of their own`() = runTest {
        val spot = Shape.Circle(Point(40.0, 40.0), 6.0)
        val reached = plain().copy(goals = listOf(Goal(Reach(spot))))
        val lost = plain().copy(goals = listOf(Goal(StayOut(spot))))
        val source = "start forward\nwait 9 seconds"
        assertEquals(RunSign.GOAL.tones.size, heard(source, 4_000, reached).of(RunSign.GOAL).size)
        assertEquals(RunSign.GOAL_LOST.tones.size, heard(source, 4_000, lost).of(RunSign.GOAL_LOST).size)
    }

    @Test
    fun `the end is told once`() = runTest {
        assertEquals(RunSign.END.tones.map { it.hertz }, heard("forward 5", 4_000).of(RunSign.END).map { it.hertz })
    }

    @Test
    fun `a robot that stands still is silent`() = runTest {
        assertEquals(emptyList(), heard("wait 9 seconds", 5_000))
    }

    @Test
    fun `nothing sounds while the brick does, and signs wait for it`() = runTest {
        val world = plain()
        val session = started("start forward\nwait 1 second\nplay 440 for 1 second\nwait 2 seconds", world)
        val sound = RunSound(world, 0)
        var silent = 0
        var last = false
        for (state in session.looks(4_000)) {
            val tones = sound.observe(state)
            if (state.robot.let { state.brick.sounding }) {
                silent++
                assertEquals(emptyList(), tones, "at ${state.milliseconds}")
            }
            last = last || tones.isNotEmpty()
        }
        session.close()
        assertTrue(silent >= 90 && last, "$silent looks")
        val ending = heard("start forward\nwait 1 second\nplay 440 for 1 second", 6_000)
        assertEquals(RunSign.END.tones.size, ending.of(RunSign.END).size)
    }

    @Test
    fun `a jump in time is silent, and what was waiting is forgotten`() = runTest {
        val world = plain()
        val session = started("forward 30", world)
        val sound = RunSound(world, 0)
        session.looks(1_000).forEach(sound::observe)
        session.advance(9_000)
        assertEquals(emptyList(), sound.observe(session.state))
        session.advance(10)
        assertEquals(emptyList(), sound.observe(session.state))
        session.close()
    }

    @Test
    fun `a moment is told by how far it is to the next thing, or by a bump`() = runTest {
        val world = plain().withBox(60.0)
        val session = started("start forward\nwait 9 seconds", world)
        val far = assertNotNull(RunSound.ofMoment(world, 0, session.state))
        session.advance(1_500)
        val near = assertNotNull(RunSound.ofMoment(world, 0, session.state))
        assertTrue(near.hertz > far.hertz, "$far $near")
        session.advance(4_000)
        assertEquals(RunSign.BUMP, assertNotNull(RunSound.ofMoment(world, 0, session.state)).sign)
        session.close()
    }

    @Test
    fun `a moment in which the brick sounds is silent`() = runTest {
        val world = plain()
        val session = started("play 440 for 2 seconds", world)
        session.advance(500)
        assertNull(RunSound.ofMoment(world, 0, session.state))
        session.close()
    }

    @Test
    fun `a thing beside the robot is not ahead of it`() = runTest {
        val world = plain(Pose(20.0, 40.0, 90.0)).withBox(60.0)
        val session = started("wait 9 seconds", world)
        session.advance(1_000)
        val aside = assertNotNull(RunSound.ofMoment(world, 0, session.state))
        session.apply(SessionInput.PlaceRobot(0, Pose(20.0, 40.0, 0.0)))
        session.advance(10)
        val ahead = assertNotNull(RunSound.ofMoment(world, 0, session.state))
        assertEquals(SoundValues.PITCHES.last(), aside.hertz)
        assertTrue(ahead.hertz > aside.hertz)
        session.close()
    }
}
