package robotran.workshop.learning

import kotlinx.coroutines.test.runTest
import robotran.documents.MemoryKeyValueStore
import kotlin.test.Test
import kotlin.test.assertEquals

class LearningProgressTest {
    private val stored =
        """{"welcomed":true,"tutorialShown":true,"folded":true,"step":"pen","stepsDone":["hello"],""" +
            """"worldsDone":["maze"],"programs":{"pen":"pen down"},"ownWork":"w1","tutorialWork":"w2"}"""

    private val progress = LearningProgress(
        welcomed = true,
        tutorialShown = true,
        folded = true,
        step = "pen",
        stepsDone = setOf("hello"),
        worldsDone = setOf("maze"),
        programs = mapOf("pen" to "pen down"),
        previousProject = "w1",
        tutorialProject = "w2",
    )

    @Test
    fun `progress of earlier versions is read`() = runTest {
        val store = MemoryKeyValueStore()
        store.write("learning", stored)
        assertEquals(progress, LearningProgress.readFrom(store))
    }

    @Test
    fun `progress is stored under the same keys`() = runTest {
        val store = MemoryKeyValueStore()
        progress.writeTo(store)
        assertEquals(stored, store.read("learning"))
    }

    @Test
    fun `a text that is no progress counts as none`() = runTest {
        val store = MemoryKeyValueStore()
        for (text in listOf("", "{", "[]", """{"stepsDone":7}""")) {
            store.write("learning", text)
            assertEquals(LearningProgress(), LearningProgress.readFrom(store))
        }
    }
}
