package robotran.build.texts

import kotlin.test.Test
import kotlin.test.assertContains
import kotlin.test.assertEquals
import kotlin.test.assertFailsWith
import kotlin.test.assertTrue

class TextSourcesTest {
    private val sources = TextSources("a.b.texts")

    @Test
    fun `a text is written so that Kotlin reads it back`() {
        val file = sources.files(mapOf("a/one.robo" to "show \"\$x\" \\ \u00e9\r\n")).getValue("texts0.kt")
        assertContains(file, """"show \"\${'$'}x\" \\ \u00e9\u000d\u000a",""")
        assertContains(file, "\"a/one.robo\"")
        assertContains(file, "package a.b\n")
    }

    @Test
    fun `a long text is written in pieces`() {
        val file = sources.files(mapOf("long" to "x".repeat(10_000))).getValue("texts0.kt")
        assertEquals(
            10_000,
            file.lines().filter { it.trim().startsWith("\"x") }.sumOf { line ->
                line.count { it == 'x' }
            },
        )
        assertTrue(file.lines().all { it.length < 5_000 })
    }

    @Test
    fun `an empty text is a piece without a letter`() {
        assertContains(sources.files(mapOf("empty" to "")).getValue("texts0.kt"), "listOf(\n    \"\",\n)")
    }

    @Test
    fun `many texts are spread over files`() {
        val files = sources.files((0 until 100).associate { "$it" to "" })
        assertEquals(setOf("texts0.kt", "texts1.kt", "texts2.kt", "texts.kt"), files.keys)
        assertContains(files.getValue("texts.kt"), "texts2()")
    }

    @Test
    fun `no texts are an empty map`() {
        assertContains(sources.files(emptyMap()).getValue("texts.kt"), "emptyMap()")
    }

    @Test
    fun `the blocks of a document are texts with their line`() {
        val document = "text\n```robolang\nbeep\nend\n```\n```ebnf\nx\n```\n```robolang\n```\n"
        assertEquals(mapOf("d.md:3" to "beep\nend\n", "d.md:10" to ""), fencedBlocks("d.md", document, "robolang"))
    }

    @Test
    fun `a block without an end is refused`() {
        assertFailsWith<IllegalArgumentException> { fencedBlocks("d.md", "```robolang\nbeep", "robolang") }
    }
}
