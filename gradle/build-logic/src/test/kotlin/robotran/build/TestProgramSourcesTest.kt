package robotran.build

import kotlin.test.Test
import kotlin.test.assertContains
import kotlin.test.assertEquals
import kotlin.test.assertFailsWith
import kotlin.test.assertTrue

class TestProgramSourcesTest {
    private val sources = TestProgramSources("a.b")

    @Test
    fun `a program is written so that Kotlin reads it back`() {
        val file = sources.files("programs", listOf(ProgramText("a/one.robo", "show \"\$x\" \\ \u00e9\r\n"))).getValue("programs0.kt")
        assertContains(file, """"show \"\${'$'}x\" \\ \u00e9\u000d\u000a",""")
        assertContains(file, "\"a/one.robo\"")
        assertContains(file, "package a.b")
    }

    @Test
    fun `a long program is written in pieces`() {
        val file = sources.files("programs", listOf(ProgramText("long", "x".repeat(10_000)))).getValue("programs0.kt")
        assertEquals(10_000, file.lines().filter { it.trim().startsWith("\"x") }.sumOf { line -> line.count { it == 'x' } })
        assertTrue(file.lines().all { it.length < 5_000 })
    }

    @Test
    fun `many programs are spread over files`() {
        val files = sources.files("programs", List(100) { ProgramText("$it", "") })
        assertEquals(setOf("programs0.kt", "programs1.kt", "programs2.kt", "programs.kt"), files.keys)
        assertContains(files.getValue("programs.kt"), "programs2()")
    }

    @Test
    fun `no programs are an empty list`() {
        assertContains(sources.files("programs", emptyList()).getValue("programs.kt"), "emptyList()")
    }

    @Test
    fun `the blocks of a document are programs with their line`() {
        val document = "text\n```robolang\nbeep\nend\n```\n```ebnf\nx\n```\n```robolang\n```\n"
        assertEquals(
            listOf(ProgramText("d.md:3", "beep\nend\n"), ProgramText("d.md:10", "")),
            fencedPrograms(ProgramText("d.md", document), "robolang"),
        )
    }

    @Test
    fun `a block without an end is refused`() {
        assertFailsWith<IllegalArgumentException> { fencedPrograms(ProgramText("d.md", "```robolang\nbeep"), "robolang") }
    }
}
