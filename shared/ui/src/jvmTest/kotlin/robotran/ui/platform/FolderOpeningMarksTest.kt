package robotran.ui.platform

import java.nio.file.Files
import kotlin.io.path.createFile
import kotlin.io.path.deleteIfExists
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertNull

class FolderOpeningMarksTest {
    private val folder = Files.createTempDirectory("marks").also { it.toFile().deleteOnExit() }

    @Test
    fun `a mark is there at once, for the next start, too, and goes again`() {
        FolderOpeningMarks(folder.resolve("opening")).put("w1a", 1_234)
        val next = FolderOpeningMarks(folder.resolve("opening"))
        assertEquals(1_234, next.timeOf("w1a"))
        assertNull(next.timeOf("w2b"))
        next.remove("w1a")
        next.remove("w1a")
        assertNull(next.timeOf("w1a"))
    }

    @Test
    fun `where nothing can be written nothing is marked`() {
        val file = folder.resolve("taken").createFile()
        val marks = FolderOpeningMarks(file)
        marks.put("w1a", 1)
        assertNull(marks.timeOf("w1a"))
        marks.remove("w1a")
        file.deleteIfExists()
    }
}
