package robotran.runcontrol

import kotlinx.coroutines.test.runTest
import robotran.language.Language
import robotran.simulation.SessionInput
import robotran.world.file.BuiltInWorlds
import robotran.world.geometry.Pose
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertFalse
import kotlin.test.assertIs
import kotlin.test.assertTrue

/** A run whose language changes while it is shown. */
class RetellingTest {
    private fun RunPlayer.meanings() = romCalls.entries.map { it.meaning }

    @Test
    fun `calls that were made and calls that come are told in the new language`() = runTest {
        val player = started(BUSY)
        player.pass(3_000)
        val english = player.meanings()
        assertTrue(english.any { "forward" in it }, "$english")
        player.setLanguage(Language.GERMAN)
        player.finishSeeking()
        assertTrue(player.meanings().any { "vorwärts" in it }, player.meanings().toString())
        assertTrue(player.meanings().none { it in english && "forward" in it })
        assertEquals(english.size, player.meanings().size)
        player.pass(4_000)
        assertTrue(player.meanings().none { "forward" in it }, player.meanings().toString())
        assertEquals(player.again(BUSY, 7_000).traceHash, player.session.traceHash)
        player.setLanguage(Language.ENGLISH)
        player.finishSeeking()
        assertEquals(english, player.meanings().take(english.size))
    }

    @Test
    fun `what was to be seen stays to be seen meanwhile and the run goes on as it was`() = runTest {
        val player = started(BUSY)
        player.pass(3_000)
        player.apply(SessionInput.PlaceRobot(0, Pose(60.0, 40.0, 45.0)))
        player.pass(3_000)
        player.seek(2_000)
        player.finishSeeking()
        val state = player.state
        val marks = player.marks
        val hash = player.session.traceHash
        player.play()
        player.setLanguage(Language.SPANISH)
        var looks = 0
        while (player.playback is PlaybackState.Seeking) {
            assertEquals(2_000, player.time)
            assertEquals(6_000, player.length)
            assertEquals(marks.size, player.marks.size)
            assertEquals(state.robots.map { it.robot.pose }, player.state.robots.map { it.robot.pose })
            if (looks++ > 10_000) break
            player.pass(50)
        }
        assertTrue(looks > 10, "$looks")
        assertEquals(2_000, player.session.milliseconds)
        assertEquals(hash, player.session.traceHash)
        assertIs<PlaybackState.Playing>(player.playback)
        assertEquals(marks.map { it.milliseconds to it.kind }, player.marks.map { it.milliseconds to it.kind })
        assertTrue(player.isInPast)
    }

    @Test
    fun `a touch, a pause or another time wanted meanwhile is done once it is told`() = runTest {
        val player = started(BUSY)
        player.pass(3_000)
        player.setLanguage(Language.GERMAN)
        player.pass(100)
        player.pause()
        player.apply(SessionInput.PlaceRobot(0, Pose(60.0, 40.0, 45.0)))
        player.finishSeeking()
        assertEquals(PlaybackState.Paused, player.playback)
        assertEquals(3, player.inputs.size)
        assertEquals(60.0, player.state.robots.first().robot.pose.x, 1e-9)
        player.setLanguage(Language.ENGLISH)
        player.pass(100)
        player.seek(1_000)
        player.finishSeeking()
        assertEquals(1_000, player.session.milliseconds)
        assertEquals(3_000, player.length)
    }

    @Test
    fun `a run that has not begun is told at once`() = runTest {
        val player = RunPlayer(setupOf("beep", BuiltInWorlds.plain))
        player.setLanguage(Language.GERMAN)
        assertFalse(player.playback is PlaybackState.Seeking)
        assertEquals(Language.GERMAN, player.session.language)
    }
}
