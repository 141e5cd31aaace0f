package robotran.workshop.learning

import kotlinx.coroutines.test.TestScope
import kotlinx.coroutines.test.runTest
import robotran.documents.MemoryKeyValueStore
import robotran.learning.Lessons
import robotran.learning.drawing.readRunDrawing
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertNotNull
import kotlin.test.assertTrue

class PupilDrawingsTest {
    private val store = MemoryKeyValueStore()
    private val square = assertNotNull(readRunDrawing("robot 600 500 90\nink 0 600 500 200 0 0 200 -200 0 0 -200"))

    private suspend fun TestScope.read(text: String) = PupilDrawings(store, this).run {
        store.write("learning-drawings", text)
        load()
        drawings
    }

    @Test
    fun `drawings are there again after a restart`() = runTest {
        val drawings = PupilDrawings(store, this)
        drawings.keep("star", square)
        drawings.keep("house", square)
        drawings.saveNow()
        val again = PupilDrawings(store, this).apply { load() }
        assertEquals(mapOf("star" to square, "house" to square), again.drawings)
    }

    @Test
    fun `what is damaged is left out, and all else stays`() = runTest {
        val found = read(
            """{"star":"${square.text.replace("\n", "\\n")}","house":"robot 1","nothing":"robot 1 2 3",""" +
                """"flower":7,"pen":{},"repeat":null}""",
        )
        assertEquals(mapOf("star" to square), found)
    }

    @Test
    fun `what holds no drawings, or far too much, counts as none`() = runTest {
        val huge = """{"star":"${"robot 1 2 3 ".repeat(100_000)}"}"""
        for (text in listOf("", "{", "[]", "7", huge)) assertEquals(emptyMap(), read(text), text.take(20))
    }

    @Test
    fun `the drawings of all lessons find room`() = runTest {
        val drawings = PupilDrawings(store, this)
        val large = assertNotNull(readRunDrawing(square.text + "\nink 0 0 0" + " -20 15".repeat(270)))
        assertTrue(large.text.length > 1_900)
        for (lesson in Lessons.all) drawings.keep(lesson.name, large)
        drawings.saveNow()
        assertTrue(assertNotNull(store.read("learning-drawings")).length < 120_000)
        assertEquals(Lessons.all.size, PupilDrawings(store, this).apply { load() }.drawings.size)
    }
}
