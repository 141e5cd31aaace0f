package robotran.learning

import kotlinx.coroutines.test.runTest
import robotran.language.Language
import robotran.learning.hint.commonConditions
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertTrue
import kotlin.time.Duration.Companion.minutes

class HintsForWrongTriesTest {
    @Test
    fun `every lesson has at least five wrong tries, every world with a task at least three`() {
        for (lesson in Lessons.all) assertTrue(wrongTriesAt(lesson).size >= TRIES, lesson.name)
        for (lesson in WorldGallery.worlds.mapNotNull { it.lesson }) {
            assertTrue(wrongTriesAt(lesson).size >= TRIES_IN_WORLD, lesson.name)
        }
    }

    @Test
    fun `no wrong try reaches the goals, and nine of ten get the hint that is meant`() = runTest(timeout = 5.minutes) {
        checkHints(allWrongTries.filterIndexed { number, _ -> number % PART == 0 })
    }

    @Test
    fun `a bumper is not blamed that can tell as well, and what is missing is told`() = runTest {
        val knock = checkNotNull(Lessons.named("knock"))
        val program = "start forward\nwait until left bumper and left bumper\nbeep\n"
        assertEquals("line missing", chooseHint(knock, runIn(knock, program), Language.ENGLISH)?.condition?.phrase)
    }

    @Test
    fun `every condition that all lessons share has a hint in every language`() {
        for (language in Language.entries) assertEquals(commonConditions, sharedHints(language).map { it.condition })
    }

    private companion object {
        const val TRIES = 5
        const val TRIES_IN_WORLD = 3

        /** One of so many wrong tries is made in each check; all are in `EveryWrongTryTest`. */
        const val PART = 4
    }
}
