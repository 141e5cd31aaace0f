package robotran.learning

import kotlinx.coroutines.test.runTest
import robotran.brick.kind.BrickKind
import robotran.language.Language
import robotran.language.ProgramLanguage
import robotran.world.ReadyRobots
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertFalse
import kotlin.test.assertSame
import kotlin.test.assertTrue
import kotlin.time.Duration.Companion.minutes

/** The lessons with a robot that has an NXT. */
class LessonsOnNxtTest {
    private val lessons = lessonsForAllBricks.map { it.on(BrickKind.NXT) }

    @Test
    fun `every solution reaches the goals with an NXT and the program that is given does not`() =
        runTest(timeout = 5.minutes) {
            val failed = mutableListOf<String>()
            for (lesson in lessons) {
                for (seed in listOf(1, 2)) {
                    val solved = runInAllPlaces(lesson, lesson.solution.text, seed)
                    if (!solved.isSolved) failed += "${lesson.name}: ${solved.run.goals}, ${solved.run.robot.pose}"
                }
                if (runIn(lesson, lesson.program.text).isSolved) failed += "${lesson.name} is solved at once"
            }
            assertTrue(failed.isEmpty(), failed.joinToString("\n"))
        }

    @Test
    fun `every lesson that is not about one brick is there for both bricks and is found by its world`() {
        for ((rcx, nxt) in lessonsForAllBricks.zip(lessons)) {
            assertEquals(listOf(BrickKind.RCX, BrickKind.NXT), listOf(rcx.brick, nxt.brick), rcx.name)
            assertSame(nxt, Lessons.lessonIn(nxt.world(Language.SPANISH)))
            assertSame(rcx, Lessons.lessonIn(rcx.world(Language.SPANISH)))
            assertEquals(rcx.program.name, nxt.program.name)
            assertEquals(Lessons.indexOf(rcx), Lessons.indexOf(nxt))
            val world = nxt.world(Language.ENGLISH)
            val withReady = world.robots.first().copy(description = ReadyRobots.NXT_PENBOT)
            assertSame(nxt, Lessons.lessonIn(world.copy(robots = listOf(withReady) + world.robots.drop(1))))
        }
    }

    @Test
    fun `a lesson says as much on an NXT in every language, with the same program text`() {
        for (lesson in lessons) {
            for (inBlocks in listOf(false, true)) {
                val said = Language.entries.map { lesson.text(it, inBlocks) }
                assertEquals(1, said.map { it.paragraphs.size }.toSet().size, lesson.name)
                assertTrue(said.all { it.paragraphs.size in 2..4 }, lesson.name)
                assertEquals(1, said.map { text -> text.whens.map { it.condition.phrase } }.toSet().size, lesson.name)
                assertEquals(1, said.map { text -> partsOf(text).map(::quoted) }.toSet().size, lesson.name)
                val all = said.flatMap(::partsOf)
                assertTrue(all.none { it.isBlank() || "(nxt)" in it || "(rcx)" in it || "(text)" in it }, lesson.name)
            }
        }
    }

    @Test
    fun `nothing that a lesson says or gives is for the other brick`() {
        for (lesson in lessons) {
            val said =
                Language.entries.flatMap { partsOf(lesson.text(it)) } + lesson.program.text + lesson.solution.text
            val java = said.joinToString("\n")
            assertFalse("josx" in java || "Sensor.S" in java || "RCX" in java || "on 2 facing" in java, lesson.name)
            if (lesson.programLanguage ==
                ProgramLanguage.JAVA
            ) {
                assertTrue("import lejos.nxt" in lesson.program.text, lesson.name)
            }
        }
        for (lesson in Lessons.all) {
            val said = Language.entries.flatMap { partsOf(lesson.text(it)) } + lesson.program.text
            assertFalse(said.any { "lejos.nxt" in it || "NXJ" in it || "NXT" in it || "SensorPort" in it }, lesson.name)
        }
    }

    private fun partsOf(text: LessonText): List<String> =
        listOf(text.title) + text.paragraphs + text.task + text.nudge + text.part + text.solution +
            text.whens.map { it.text } + listOfNotNull(text.again)

    private fun quoted(text: String): List<String> =
        text.split('`').filterIndexed { place, _ -> place % 2 == 1 }.sorted()
}
