package robotran.tinyvm.programs

import robotran.tinyvm.testPrograms
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertTrue

/**
 * Runs the test programs of the class library on the virtual brick, except those that take long as wasm:
 * [LimitProgramsTest], [InfraredProgramsTest].
 */
class ProgramsTest {
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
    fun `programs about streams of bytes do what they say`() = doWhatTheySay("io")

    @Test
    fun `programs about timers recycled objects and assertions do what they say`() = doWhatTheySay("josxutil")

    @Test
    fun `programs about what java lang has do what they say`() = doWhatTheySay("lang")

    @Test
    fun `programs about the Java language do what they say`() = doWhatTheySay("language")

    @Test
    fun `programs about motors sensors buttons display and sounds do what they say`() = doWhatTheySay("rcx")

    @Test
    fun `programs about behaviours activities and navigators do what they say`() = doWhatTheySay("robotics")

    @Test
    fun `programs about threads do what they say`() = doWhatTheySay("threads")

    @Test
    fun `programs about lists tables and random numbers do what they say`() = doWhatTheySay("util")
}
