package robotran.learning

import kotlinx.coroutines.test.runTest
import robotran.language.Language
import robotran.robolang.wording.ChangedWords
import robotran.robolang.wording.changeWords
import robotran.robolang.words.Vocabulary
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertIs
import kotlin.time.Duration.Companion.minutes

/** Pupils write the lessons in the words of any language. */
class OtherWordsTest {
    private val others = Language.entries - Language.ENGLISH
    private val lessons = Lessons.all.filter { it.program.name.endsWith(".robo") }

    @Test
    fun `every program of a lesson goes into each language and back`() {
        for (lesson in lessons) {
            for (program in listOf(lesson.program, lesson.solution)) {
                for (language in others) {
                    assertEquals(program.text, changed(changed(program.text, language), Language.ENGLISH), lesson.name)
                }
            }
        }
    }

    @Test
    fun `a solution makes the same run in the words of each language`() = runTest(timeout = 5.minutes) {
        for (lesson in lessons.filterIndexed { number, _ -> number % PART == 0 }) {
            val english = runIn(lesson, lesson.solution.text)
            for (language in others) {
                val other = runIn(lesson, changed(lesson.solution.text, language))
                assertEquals(english.run.trail, other.run.trail, lesson.name)
                assertEquals(english.run.ink.lengthCentimetres, other.run.ink.lengthCentimetres, lesson.name)
                assertEquals(english.run.milliseconds to true, other.run.milliseconds to other.isSolved, lesson.name)
            }
        }
    }

    @Test
    fun `a wrong try gets the same hint in the words of each language`() = runTest(timeout = 5.minutes) {
        for (wrong in allWrongTries.filterIndexed { number, _ -> number % WRONG_PART == 0 }) {
            if (!wrong.lesson.program.name.endsWith(".robo")) continue
            val english = chooseHint(wrong.lesson, runIn(wrong.lesson, wrong.program), Language.ENGLISH)
            for (language in others) {
                val attempt = runIn(wrong.lesson, changed(wrong.program, language))
                assertEquals(
                    english,
                    chooseHint(wrong.lesson, attempt, Language.ENGLISH),
                    "${wrong.lesson.name} $language",
                )
            }
        }
    }

    private fun changed(text: String, language: Language): String =
        assertIs<ChangedWords.Success>(changeWords(text, Vocabulary.of(language)), text).text

    private companion object {
        const val PART = 6
        const val WRONG_PART = 12
    }
}
