package robotran.learning.thorough

import kotlinx.coroutines.test.runTest
import robotran.brick.kind.BrickKind
import robotran.language.Language
import robotran.learning.Lesson
import robotran.learning.Lessons
import robotran.learning.lessonsOf
import robotran.learning.runInAllPlaces
import robotran.world.BumperPart
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.time.Duration.Companion.minutes

class LessonsOnHubsTest {
    @Test
    fun `a hub has the lessons that its robot can do as they are, and no others`() = runTest(timeout = 30.minutes) {
        val hubs = BrickKind.entries.filter { it.java == null }
        val all = hubs.associateWith { Lessons.allOn(it) }
        val solved = all.mapValues { (_, lessons) -> lessons.filter { hasBumpersOrAsksForNone(it) && isSolved(it) } }
        // Lessons that are about one brick are no others' as well.
        val listed = all.mapValues { (brick, lessons) ->
            lessonsOf(brick).filter { lesson -> lessons.any { it.name == lesson.name } }
        }
        assertEquals(linesOf(solved), linesOf(listed))
    }

    private fun linesOf(lessons: Map<BrickKind, List<Lesson>>): String = lessons.entries
        .joinToString("\n") { (brick, list) -> "${brick.label}: ${list.map { it.name }.sorted().joinToString()}" }

    /** A lesson about bumpers is false for a robot without any, even if the task can be done without touching anything. */
    private fun hasBumpersOrAsksForNone(lesson: Lesson): Boolean = "bumper" !in lesson.solution.text ||
        lesson.world(Language.ENGLISH).robots.first().description.parts.any { it is BumperPart }

    /** Whether the solution reaches the goals with three seeds; one that the hub cannot read does not. */
    private suspend fun isSolved(lesson: Lesson): Boolean = (1..3).all { seed ->
        try {
            runInAllPlaces(lesson, lesson.solution.text, seed).isSolved
        } catch (_: AssertionError) {
            false
        }
    }
}
