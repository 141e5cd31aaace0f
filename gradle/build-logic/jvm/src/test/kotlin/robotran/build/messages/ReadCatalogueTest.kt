package robotran.build.messages

import robotran.build.texts.fencedBlocks
import java.io.File
import kotlin.test.Test
import kotlin.test.assertContains
import kotlin.test.assertEquals
import kotlin.test.assertFailsWith
import kotlin.test.assertFalse

class ReadCatalogueTest {
    private val languages = readLanguages(
        "languages.md",
        """
            | tag | constant | own name | decimal sign | sign between thousands | digits without it | numbers in the singular | a line goes on to the |
            |---|---|---|---|---|---|---|---|
            | en | ENGLISH | English | `.` | `,` | 3 | 1 | right |
            | pt-BR | BRAZILIAN_PORTUGUESE | Português | `,` | `.` | 3 | 0, 1 | right |
        """.trimIndent(),
    )

    private val text = """
        - package: robotran.world.messages
        - imports: robotran.world.TouchKind,
          robotran.world.Wall

        # internal TouchMessages: PlaceMessages

        What is said when something is touched.

        ## touched(kind: TouchKind, near: Map<Wall, List<Int>>, name: String?)

        It touched [kind].

        - en: It touched {thing(kind)}
          {near.size} times.
        - pt-BR: Tocou em {thing(kind)}.

        ## -thing(kind: TouchKind)

        - en: a wall
        - pt-BR: uma parede

        ## missing()

        - en: Nothing.
    """.trimIndent()

    @Test
    fun `tables, messages and terms are read`() {
        val catalogue = readCatalogue("touch.md", text)
        val table = catalogue.tables.single()
        assertEquals("robotran.world.messages", catalogue.packageName)
        assertEquals(listOf("robotran.world.TouchKind", "robotran.world.Wall"), catalogue.imports)
        assertEquals(listOf("PlaceMessages"), table.bases)
        assertEquals(listOf("touched", "thing", "missing"), table.messages.map { it.name })
        assertEquals(
            listOf("TouchKind", "Map<Wall, List<Int>>", "String?"),
            table.messages[0].parameters.map {
                it.type
            },
        )
        assertEquals(listOf(false, true, false), table.messages.map { it.isTerm })
        assertEquals("It touched [kind].", table.messages[0].documentation)
    }

    @Test
    fun `an interface and a class for each language are written`() {
        val files = MessagesWriter(readCatalogue("touch.md", text), languages).files()
        assertEquals(
            setOf("TouchMessages.kt", "EnglishTouchMessages.kt", "BrazilianPortugueseTouchMessages.kt"),
            files.keys,
        )
        val table = files.getValue("TouchMessages.kt")
        assertContains(table, "internal interface TouchMessages : PlaceMessages {")
        assertContains(table, "Language.BRAZILIAN_PORTUGUESE -> BrazilianPortugueseTouchMessages")
        assertFalse("thing(" in table, "terms are private")
        val english = files.getValue("EnglishTouchMessages.kt")
        assertContains(
            english,
            "class EnglishTouchMessages : TouchMessages, PlaceMessages by PlaceMessages.of(Language.ENGLISH) {",
        )
        assertContains(english, "\"It touched \${thing(kind)} \${near.size} times.\"")
        assertContains(english, "private fun thing(kind: TouchKind): String")
    }

    @Test
    fun `a missing sentence is said in English`() {
        val files = MessagesWriter(readCatalogue("touch.md", text), languages).files()
        assertContains(files.getValue("BrazilianPortugueseTouchMessages.kt"), "\"Nothing.\"")
        val table = readCatalogue("touch.md", text).tables.single()
        assertEquals(listOf(emptyList(), listOf("missing")), languages.map { missingIn(table, it) })
    }

    @Test
    fun `an enum of the languages is written`() =
        assertContains(languageEnum(languages), "BRAZILIAN_PORTUGUESE(\"pt-BR\", \"Português\", ',', \".\", 3, false),")

    @Test
    fun `the catalogue in the page on messages is one`() {
        val page = File("../../../docs/messages.md")
        val example = fencedBlocks(page.name, page.readText(), "text").entries.single()
        val files = MessagesWriter(readCatalogue(example.key, example.value), languages).files()
        assertContains(files.getValue("EnglishTouchMessages.kt"), "TouchKind.WALL -> \"a wall\"")
    }

    @Test
    fun `a mistake is told with its line`() {
        fun mistake(old: String, new: String) =
            assertFailsWith<CatalogueException> { readCatalogue("touch.md", text.replace(old, new)) }.message.orEmpty()
        assertContains(mistake("- en: Nothing.", "- de: Nichts."), "touch.md:22")
        assertContains(mistake("{thing(kind)}.", "{thing(kind}."), "touch.md:9: pt-BR")
        assertContains(mistake("## missing()", "## missing"), "touch.md:22")
        assertContains(mistake("- package: robotran.world.messages", ""), "no package")
        assertContains(mistake("## missing()", "## -thing(kind: TouchKind)"), "twice")
    }
}
