package robotran.learning

import kotlinx.coroutines.test.runTest
import robotran.language.Language
import robotran.languagesupport.SourceFile
import robotran.learning.hint.CodeLine
import robotran.learning.hint.codeLines
import robotran.learning.hint.isNumber
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.time.Duration.Companion.minutes

/** Programs that do what the task wants and then more, and programs that come near it. */
class RightOnTheWayTest {
    private val tasks = Lessons.all + WorldGallery.worlds.mapNotNull { it.lesson }

    /**
     * The other tasks have only goals about what a run does once, such as to reach the end of a maze. Whatever comes
     * after that, it has been done, so there is no such wrong try.
     */
    private val decidedAtEnd = tasks.filter { lesson ->
        lesson.world(Language.ENGLISH).goals.any { it.condition.isDecidedAtEnd }
    }

    @Test
    fun `each task that the end of the run decides has a wrong try that was right on its way`() =
        runTest(timeout = 10.minutes) {
            val without = decidedAtEnd.filterNot { lesson ->
                wrongTriesAt(lesson).any { (name, text) ->
                    isRightOnTheWay(lesson, SourceFile(nameIn(lesson, name), text))
                }
            }
            assertEquals(emptyList(), without.map { it.name })
        }

    @Test
    fun `what a pupil begins with is not right where the task names another number`() = runTest(timeout = 10.minutes) {
        val accepted = Lessons.all.flatMap { lesson ->
            withNumbersOf(lesson).filter { (_, text) -> runIn(lesson, text).isSolved }.map { (what, _) ->
                "${lesson.name}: $what"
            }
        }
        assertEquals(emptyList(), accepted)
    }

    /**
     * The solution of [lesson] with another number in the place of one that the task names: that of a line alike in the
     * given program, or that of a new block.
     */
    private fun withNumbersOf(lesson: Lesson): List<Pair<String, String>> {
        val given = codeLines(lesson.program.text)
        // More than "at least" is right as well.
        val task = lesson.text(Language.ENGLISH).task.replace(Regex("at least [0-9]+"), "")
        val named = NUMBER.findAll(task).map { it.value }.toSet()
        val lines = lesson.solution.text.lines()
        return lines.distinct().flatMap { text ->
            val line = codeLines(text).singleOrNull() ?: return@flatMap emptyList()
            val begun = given.filter { other -> other.words == line.words }.flatMap { it.numbers } +
                listOfNotNull(NEW_BLOCKS[line.tokens.first()])
            NUMBER.findAll(text.substringBefore("//")).filter { it.value in named }.toList().flatMap { match ->
                (begun.distinct() - line.numbers.toSet()).map { other ->
                    // Both branches of an "if" may have the line.
                    val changed = lines.map { if (it == text) text.replaceRange(match.range, other) else it }
                    "$text: $other" to changed.joinToString("\n")
                }
            }
        }
    }

    private val CodeLine.words get() = tokens.filterNot(::isNumber)

    private val CodeLine.numbers get() = tokens.filter(::isNumber)

    private fun nameIn(lesson: Lesson, name: String) = if (name.endsWith(".java")) lesson.program.name else name

    private companion object {
        /** The numbers of new blocks. */
        val NEW_BLOCKS = mapOf("forward" to "20", "backward" to "20")
        val NUMBER = Regex("(?<![\\w.])[0-9]+(\\.[0-9]+)?")
    }
}
