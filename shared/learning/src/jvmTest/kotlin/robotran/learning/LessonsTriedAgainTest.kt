package robotran.learning

import kotlinx.coroutines.test.runTest
import robotran.brick.kind.BrickKind
import robotran.language.Language
import robotran.learning.hint.HintCondition
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertNotEquals
import kotlin.test.assertTrue
import kotlin.time.Duration.Companion.minutes

/** The lessons whose programs are tried in a second place. */
class LessonsTriedAgainTest {
    private val lessons = Lessons.all.filter { it.places.size > 1 }

    @Test
    fun `a lesson says what is different in the second place, if it has one, on both bricks`() {
        for (lesson in Lessons.all.flatMap { listOf(it, it.on(BrickKind.NXT)) }) {
            val said = Language.entries.mapNotNull { lesson.text(it).again }
            val count = if (lesson.places.size > 1) Language.entries.size else 0
            assertEquals(count, said.toSet().size, lesson.name)
            assertTrue(said.none { '`' in it }, lesson.name)
        }
        assertTrue(lessons.size >= LEAST, "only ${lessons.size}")
    }

    @Test
    fun `the second place has the same robots, paper and time, but something is measured otherwise`() {
        for (lesson in lessons.flatMap { listOf(it, it.on(BrickKind.NXT)) }) {
            val (first, again) = lesson.places.map { lesson.world(Language.SPANISH, it) }
            assertEquals(first.paper, again.paper, lesson.name)
            assertEquals(first.timeLimit, again.timeLimit, lesson.name)
            assertEquals(first.robots.map { it.name to it.description }, again.robots.map { it.name to it.description })
            assertEquals(first.title to first.task, again.title to again.task)
            assertNotEquals(first, again, lesson.name)
            assertEquals(listOf(LessonPlace.FIRST, LessonPlace.AGAIN), listOf(first, again).map { lesson.placeOf(it) })
            assertEquals(lesson, Lessons.lessonIn(again))
        }
    }

    @Test
    fun `each has a wrong try that reaches the goals in the first place only`() = runTest(timeout = 5.minutes) {
        val tries = allWrongTries.filter { it.expectedHint == HintCondition.AGAIN }
        assertEquals(lessons.toSet(), tries.map { it.lesson }.toSet())
        val passed = tries.associate { wrong ->
            "$wrong" to wrong.lesson.places.filter { runIn(wrong.lesson, wrong.program, place = it).isSolved }
        }
        assertEquals(emptyMap(), passed.filterValues { it != listOf(LessonPlace.FIRST) })
    }

    @Test
    fun `who knows the way by heart gets a hint about that before all others`() = runTest {
        val edge = checkNotNull(Lessons.named("edge"))
        val attempt = runInAllPlaces(edge, "forward 46\nbeep\n")
        val hint = chooseHint(edge, attempt, Language.ENGLISH)
        assertEquals(HintCondition.AGAIN, hint?.condition?.phrase)
        assertEquals(
            "word missing: start",
            chooseHint(edge, runIn(edge, "forward 20\nbeep\n"), Language.ENGLISH).phrase,
        )
    }

    private val Hint?.phrase get() = this?.condition?.phrase

    private companion object {
        /** Where a sensor is the point. */
        const val LEAST = 16
    }
}
