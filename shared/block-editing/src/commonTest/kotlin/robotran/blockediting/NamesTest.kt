package robotran.blockediting

import robotran.language.Language
import robotran.language.source.SourceSpan
import robotran.robolang.messages.RobolangMessages
import robotran.robolang.outline.NameKind
import robotran.robolang.outline.PhrasePart
import robotran.robolang.words.ValueKind
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertTrue

class NamesTest {
    private val program = blocksOf(
        """
        const k = 2
        var list = [1, 2]
        for i from 1 to 3
          var inner = i > 1
          beep
        end
        procedure go(far)
          forward far
        end
        function twice(n)
          return n * k
        end
        go(twice(4))
        """.trimIndent(),
        messages = RobolangMessages.of(Language.ENGLISH),
    )

    private fun namesAt(text: String) = program.namesAt(program.at(text)).orEmpty().map { it.text }

    @Test
    fun `a line may use what is declared above it and around it, and all own commands`() {
        assertEquals(listOf("go", "twice"), namesAt("const"))
        assertEquals(listOf("k", "list", "i", "inner", "go", "twice"), namesAt("beep"))
        assertEquals(listOf("k", "list", "go", "far", "twice"), namesAt("forward"))
        assertEquals(listOf("k", "list", "go", "twice", "n"), namesAt("return"))
        assertEquals(listOf("k", "list", "go", "twice"), namesAt("go("))
    }

    @Test
    fun `names have the types that the checker finds`() {
        val types = program.outline.names.associate { it.text to it.type }
        assertEquals(ValueKind.LIST, types["list"])
        assertEquals(ValueKind.CONDITION, types["inner"])
        assertEquals(ValueKind.NUMBER, types["i"])
        assertEquals(ValueKind.NUMBER, types["far"])
        assertEquals(ValueKind.NUMBER, types["twice"])
        assertEquals(listOf("far"), program.outline.names.first { it.kind == NameKind.PROCEDURE }.parameters)
    }

    @Test
    fun `a menu offers the names that fit`() {
        fun offered(text: String) = program.text.indexOf(text).let { start ->
            program.namesFor(checkNotNull(program.partAt(SourceSpan(start, start + text.length)))).map { it.text }
        }
        assertEquals(listOf("k", "i", "twice"), offered("i > 1").let { _ -> offeredInner() })
        assertEquals(listOf("go"), offeredAt("go", program.text.lastIndexOf("go(")))
    }

    private fun offeredInner(): List<String> {
        val start = program.text.indexOf("i > 1")
        return program.namesFor(checkNotNull(program.partAt(SourceSpan(start, start + 1)) as? PhrasePart.Value)).map {
            it.text
        }
    }

    private fun offeredAt(text: String, start: Int): List<String> =
        program.namesFor(checkNotNull(program.partAt(SourceSpan(start, start + text.length)))).map { it.text }

    @Test
    fun `what is used is visible there, in every program without mistakes about names`() {
        var uses = 0
        for ((path, text) in allPrograms) {
            val outline = blocksOf(text, messages = RobolangMessages.of(Language.ENGLISH)).outline
            for (name in outline.names) {
                for (use in name.uses - name.declaredAt) {
                    val line = outline.lines.first { use.start in it.span.start..it.span.end }.index
                    assertTrue(outline.namesBefore(line).any { it === name }, "$path: ${name.text} in line ${line + 1}")
                    uses++
                }
            }
        }
        assertTrue(uses > 500, "$uses uses")
    }

    @Test
    fun `a free name differs from all`() {
        assertEquals("side", program.freeName("side"))
        assertEquals("K2", program.freeName("K"))
        assertTrue(isName("größe") && !isName("end") && !isName("a b") && !isName("") && !isName("x // y"))
    }
}
