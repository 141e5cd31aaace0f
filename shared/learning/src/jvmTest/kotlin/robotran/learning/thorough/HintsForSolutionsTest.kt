package robotran.learning.thorough

import kotlinx.coroutines.test.runTest
import robotran.language.Language
import robotran.language.ProgramLanguage
import robotran.learning.Lessons
import robotran.learning.chooseHint
import robotran.learning.hint.commonConditions
import robotran.learning.runIn
import robotran.learning.worldTasks
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.time.Duration.Companion.minutes

/** What hints say about a solution, and about one that lacks a line. */
class HintsForSolutionsTest {
    @Test
    fun `no hint about words or lines would fit the solution itself`() = runTest(timeout = 5.minutes) {
        val fitting = (Lessons.all + worldTasks).flatMap { lesson ->
            val attempt = runIn(lesson, lesson.solution.text)
            val own = lesson.text(Language.ENGLISH).whens.map { it.condition }.filter { it.phrase.startsWith("word ") }
            (own + commonConditions.take(ABOUT_THE_PROGRAM)).filter { it.match(attempt) != null }
                .map { "${lesson.name}: ${it.phrase}" }
        }
        assertEquals(emptyList(), fitting)
    }

    @Test
    fun `where only a line is missing, no hint blames one that is there`() = runTest(timeout = 5.minutes) {
        val blamed = Lessons.all.filter { it.programLanguage == ProgramLanguage.ROBOLANG }.flatMap { lesson ->
            val lines = lesson.solution.text.lines()
            // A block has its line at the end, too.
            val single = lines.indices.filter { number ->
                val words = lines[number].trim().split(" ")
                words.first() in SINGLE_LINES && lines.count { it == lines[number] } == 1
            }
            single.mapNotNull { number ->
                val attempt = runIn(lesson, lines.filterIndexed { other, _ -> other != number }.joinToString("\n"))
                val condition = chooseHint(lesson, attempt, Language.ENGLISH)?.condition?.phrase
                "${lesson.name} without ${lines[number].trim()}: $condition".takeIf { condition in ABOUT_OTHER_LINES }
            }
        }
        assertEquals(emptyList(), blamed)
    }

    private companion object {
        /** What stands alone on its line. */
        val SINGLE_LINES = setOf("forward", "backward", "turn", "pen", "wait", "beep", "play", "show", "start", "stop")

        val ABOUT_OTHER_LINES = setOf(
            "units mixed up",
            "turned the wrong way",
            "drove the wrong way",
            "wrong sensor",
            "compared the wrong way",
            "one too few",
            "one too many",
            "wrong angle",
            "wrong number",
            "lines swapped",
            "line too many",
        )

        /** The conditions on the program come before those on the run. */
        val ABOUT_THE_PROGRAM = commonConditions.indexOfFirst { it.phrase == "never moved" }
    }
}
