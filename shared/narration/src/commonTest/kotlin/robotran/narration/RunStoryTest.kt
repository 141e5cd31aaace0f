package robotran.narration

import kotlinx.coroutines.test.runTest
import robotran.language.Language
import robotran.simulation.state.SessionState
import robotran.world.World
import robotran.world.file.BuiltInWorlds
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertTrue

/** On all targets, so that a run has the same words on each. */
class RunStoryTest {
    private val plain: World get() = BuiltInWorlds.plain

    @Test
    fun `a square is four times the same`() = runTest {
        val run = runOf("pen down\nrepeat 4 times\n  forward 20\n  turn left 90\nend")
        assertEquals(
            listOf(
                "The robot did this 4 times: drove 20 cm and turned left 90 degrees.",
                "80 cm were drawn.",
                "The program ended at 6 s.",
            ),
            run.story(plain),
        )
        assertEquals(
            listOf(
                "Der Roboter machte das 4-mal: fuhr 20 cm vorwärts und drehte sich 90 Grad nach links.",
                "80 cm wurden gezeichnet.",
                "Das Programm war bei 6 s zu Ende.",
            ),
            run.story(plain, Language.GERMAN),
        )
    }

    @Test
    fun `moves that differ are told one after the other`() = runTest {
        val run = runOf("forward 40\nturn left 90\nforward 15\nturn right 30\nwait 2 seconds\nbackward 10")
        assertEquals(
            "The robot drove 40 cm, turned left 90 degrees, drove 15 cm, turned right 30 degrees and waited 1.9 s.",
            run.story(plain).first(),
        )
        assertEquals("Then it drove 10 cm backwards.", run.story(plain)[1])
        assertEquals("Después retrocedió 10 cm.", run.story(plain, Language.SPANISH)[1])
    }

    @Test
    fun `a bump is told with its time and what was hit`() = runTest {
        val run = runOf("forward 120")
        assertEquals(
            listOf("The robot drove 51 cm.", "It bumped once: at 2.5 s into a wall.", "The program ended at 6 s."),
            run.story(plain),
        )
        assertEquals(
            "Er ist einmal angestoßen: bei 2,5 s an eine Wand.",
            run.story(plain, Language.GERMAN)[1],
        )
    }

    @Test
    fun `what was missing for the goal is said as the list of goals says it`() = runTest {
        val corridor = worldOf("corridor")
        val run = runOf("forward 40\nturn left 90\nforward 40", corridor)
        assertEquals("100.4 cm short of the marked area.", run.story(corridor).last())
    }

    @Test
    fun `a line is followed in few words`() = runTest {
        val world = worldOf("line-loop")
        val run = runOf(
            "robot\n  light sensor on 2 facing down\nend\nrepeat forever\n  if light < 44\n    motor A stop\n" +
                "    motor C forward\n  else\n    motor A forward\n    motor C stop\n  end\n  wait 10 milliseconds\nend",
            world,
        )
        val story = run.story(world)
        assertTrue(story.size <= RunStory.MAX_SENTENCES, "$story")
        assertTrue(story.any { "it came to the line \"track\"" in it }, "$story")
    }

    @Test
    fun `an endless loop is told in a few sentences`() = runTest {
        val run = runOf("repeat forever\n  forward 10\n  turn right 60\nend")
        assertEquals(
            listOf(
                "The robot did this 74 times: drove 10 cm and turned right 60 degrees.",
                "Then it drove 10 cm and turned right 54 degrees.",
                "At 60 s the program still runs.",
            ),
            run.story(plain),
        )
    }

    @Test
    fun `a long run is told by the length of its way alone`() = runTest {
        val run = runOf("repeat forever\n  forward 10\n  turn right 60\nend", milliseconds = 400_000)
        assertEquals(
            listOf("The robot drove 50 m in all.", "At 400 s the program still runs."),
            run.story(plain),
        )
    }

    @Test
    fun `of several robots each is named`() = runTest {
        val sumo = worldOf("sumo")
        val story = runOf("forward 60", sumo).story(sumo)
        assertTrue(story.size <= RunStory.MAX_SENTENCES, "$story")
        assertTrue(story.any { it.startsWith("The robot \"yellow\" drove") }, "$story")
        assertTrue(story.any { it.startsWith("The robot \"red\" drove") }, "$story")
    }

    @Test
    fun `before the first run nothing has happened`() {
        assertEquals(
            listOf("Nothing has happened yet."),
            storyOf(plain, emptyList<SessionState>(), emptyList()).sentences(Language.ENGLISH),
        )
    }
}
