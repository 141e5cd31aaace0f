package robotran.tinyvm.programs

import robotran.tinyvm.testPrograms
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertTrue

/** Runs every test program of the class library on the virtual brick. */
class ProgramsTest {
    private fun check(folder: String) {
        val programs = testPrograms.filterKeys { it.startsWith("$folder/") }
        assertTrue(programs.isNotEmpty(), "There are no programs in $folder.")
        assertEquals("", programs.flatMap { (path, source) -> differences(path, source) }.joinToString("\n"))
    }

    @Test
    fun `all programs are run`() {
        val folders =
            listOf(
                "io",
                "josxutil",
                "lang",
                "language",
                "limits",
                "mistakes",
                "rcx",
                "rcxcomm",
                "robotics",
                "threads",
                "util",
            )
        assertEquals(folders.toSet(), testPrograms.keys.map { it.substringBefore('/') }.toSet())
        assertTrue(testPrograms.size >= 120, "There are only ${testPrograms.size} programs.")
    }

    @Test
    fun `programs about streams of bytes do what they say`() = check("io")

    @Test
    fun `programs about timers recycled objects and assertions do what they say`() = check("josxutil")

    @Test
    fun `programs about what java lang has do what they say`() = check("lang")

    @Test
    fun `programs about the Java language do what they say`() = check("language")

    @Test
    fun `programs about the limits of a brick do what they say`() = check("limits")

    @Test
    fun `programs about motors sensors buttons display and sounds do what they say`() = check("rcx")

    @Test
    fun `programs about infrared do what they say`() = check("rcxcomm")

    @Test
    fun `programs about behaviours activities and navigators do what they say`() = check("robotics")

    @Test
    fun `programs about threads do what they say`() = check("threads")

    @Test
    fun `programs about lists tables and random numbers do what they say`() = check("util")
}
