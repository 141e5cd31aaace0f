package robotran.build.messages

import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertFailsWith

class ReadPatternTest {
    private val english = SpokenLanguage("en", "ENGLISH", "English", ".", ",", 3, listOf(1))
    private val french = SpokenLanguage("fr", "FRENCH", "Français", ",", " ", 3, listOf(0, 1))

    private fun kotlin(pattern: String, language: SpokenLanguage = english): String {
        val parameters = listOf(
            Parameter("count", "Int"),
            Parameter("kind", "Kind?"),
            Parameter("isLeft", "Boolean"),
            Parameter("names", "List<String>"),
        )
        val message = Message("touched", false, parameters, "", emptyMap())
        return PatternWriter(message, language).expression(readPattern(pattern))
    }

    @Test
    fun `a sentence is a string with its placeholders`() =
        assertEquals("\"\${kind.name} is \${quoted(kind.text)}.\"", kotlin("{kind.name} is {quoted(kind.text)}."))

    @Test
    fun `what Kotlin would read otherwise is escaped`() =
        assertEquals("""" costs \${'$'}5 and \"more\" \\"""", kotlin(" costs \$5 and \"more\" \\"))

    @Test
    fun `an apostrophe is one, unless it quotes a brace`() =
        assertEquals("\"don't write { x } or it's ' }\"", kotlin("don't write '{' x '}' or it's '' '}'"))

    @Test
    fun `a plural counts in the way of its language`() {
        val pattern = "{count, plural, =0 {none} one {one} other {# of them}}"
        assertEquals("""when (count) { 0 -> "none"; 1 -> "one"; else -> "${'$'}{count} of them" }""", kotlin(pattern))
        assertEquals(
            """when (count) { 0 -> "none"; 0, 1 -> "one"; else -> "${'$'}{count} of them" }""",
            kotlin(pattern, french),
        )
    }

    @Test
    fun `a number sign outside a plural is itself`() = assertEquals("\"# #define\"", kotlin("# #define"))

    @Test
    fun `a choice names entries, subtypes, flags and nothing`() {
        assertEquals(
            """when (kind) { Kind.RED, Kind.BLUE -> "a"; is Kind.Other -> "b"; null -> ""; else -> "c" }""",
            kotlin("{kind, select, RED | BLUE {a} Other {b} null {} other {c}}"),
        )
        assertEquals(
            """"to the ${'$'}{when (isLeft) { true -> "left"; else -> "right" }}"""",
            kotlin("to the {isLeft, select, true {left} other {right}}"),
        )
    }

    @Test
    fun `numbers and lists are written as the language does`() = assertEquals(
        """"${'$'}{language.decimal(kind.far)} ${'$'}{language.grouped(count)} ${'$'}{listed(names, "and")}"""",
        kotlin("{kind.far, number} {count, grouped} {names, list, and}"),
    )

    @Test
    fun `a choice within a choice keeps the blanks of its arms`() = assertEquals(
        """when (isLeft) { true -> " a ${'$'}{when (count) { 1 -> "x "; else -> "y${'$'}{count}" }}"; else -> "" }""",
        kotlin("{isLeft, select, true { a {count, plural, one {x } other {y#}}} other {}}"),
    )

    @Test
    fun `what is not well-formed is refused`() {
        for (pattern in listOf(
            "{",
            "}",
            "{}",
            "{a",
            "{a, plural}",
            "{a, size, b {c}}",
            "{a, select, }",
            "{a, select, b {",
            "'{",
        )) {
            assertFailsWith<CatalogueException>(pattern) { readPattern(pattern) }
        }
        assertFailsWith<CatalogueException> { kotlin("{kind.name, select, RED {a}}") }
    }
}
