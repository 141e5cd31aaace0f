package robotran.documents

import robotran.language.Language
import robotran.language.ProgramLanguage
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertNotEquals
import kotlin.test.assertTrue

class ProjectNamesTest {
    @Test
    fun `a name that nobody has stays as it is`() {
        assertEquals("Maze", uniqueProjectName("Maze", listOf("Maze 2", "maze")))
        assertEquals("Maze 2", uniqueProjectName("Maze 2", listOf("Maze")))
    }

    @Test
    fun `a name that is taken gets the least number that is free`() {
        assertEquals("Maze 2", uniqueProjectName("Maze", listOf("Maze")))
        assertEquals("Maze 4", uniqueProjectName("Maze", listOf("Maze", "Maze 2", "Maze 3", "Maze 5")))
        assertEquals("Maze 3", uniqueProjectName("Maze 2", listOf("Maze", "Maze 2")))
    }

    @Test
    fun `a name stays short, and whole`() {
        val long = "x".repeat(SavedProject.MAXIMUM_NAME - 3) + "\uD83D\uDE00"
        val free = uniqueProjectName(long, listOf(long))
        assertTrue(free.length <= SavedProject.MAXIMUM_NAME && free.endsWith("x 2"), free)
    }

    @Test
    fun `every programming language has a kind of files`() {
        assertEquals(
            ProgramLanguage.entries.map {
                it.extension
            },
            ProgramLanguage.entries.map { it.fileKind.extension },
        )
    }

    @Test
    fun `a new work and that of the tutorial have a name in every language`() {
        assertEquals(Language.entries.size, Language.entries.map(::defaultProjectName).toSet().size)
        assertEquals(Language.entries.size, Language.entries.map(::tutorialProjectName).toSet().size)
        for (language in Language.entries) assertNotEquals("", defaultProjectName(language))
    }
}
