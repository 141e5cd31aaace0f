package robotran.ui.language

import robotran.language.Language
import robotran.uikit.*
import java.io.File
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertTrue

/** Compares the UI strings of all languages. */
class StringsTest {
    private val english = stringsOf(Language.ENGLISH)
    private val others = (Language.entries - Language.ENGLISH).associateWith(::stringsOf)

    @Test
    fun `every language has the same keys`() {
        assertTrue(english.size > 1_400, "Only ${english.size} English strings were found.")
        val wrong = others.flatMap { (language, texts) ->
            (english.keys - texts.keys).map { "$it is missing in $language" } +
                (texts.keys - english.keys).map { "$it is only in $language" }
        }
        assertEquals(emptyList(), wrong)
    }

    @Test
    fun `a text has the same arguments in every language`() = forEachTranslation { one, other ->
        if (argumentsIn(one) == argumentsIn(other)) {
            null
        } else {
            "has other arguments than \"$one\""
        }
    }

    @Test
    fun `no English text is left in another language`() = forEachTranslation { one, other ->
        val words = WORD.findAll(ARGUMENT.replace(one, "")).map { it.value }
        if (one == other && words.any { it !in SHARED_WORDS }) "is in English" else null
    }

    @Test
    fun `no text is much longer than in the other languages`() {
        val all = others + (Language.ENGLISH to english)
        val wrong = all.flatMap { (language, texts) ->
            texts.filterValues { ARGUMENT !in it && '{' !in it }.mapNotNull { (key, text) ->
                val longest = (all - language).values.mapNotNull { it[key]?.length }.max()
                val room = if (longest <= BUTTON) longest * BUTTON_ROOM + FEW else longest * SENTENCE_ROOM + FEW
                if (text.length > room) "$key in $language has ${text.length} letters, others $longest: $text" else null
            }
        }
        assertEquals(emptyList(), wrong)
    }

    @Test
    fun `a phrase that stands in several places has one translation`() {
        val phrases = english.entries.filter { ' ' in it.value && '{' !in it.value }
            .groupBy({ it.value.lowercase() }, { it.key }).filterValues { it.size > 1 }
        val wrong = others.flatMap { (language, texts) ->
            phrases.filterKeys { it !in SEVERAL_MEANINGS }.mapNotNull { (phrase, keys) ->
                val translated = keys.map { texts.getValue(it).lowercase() }.distinct()
                if (translated.size > 1) "$phrase in $language: $translated" else null
            }
        }
        assertEquals(emptyList(), wrong)
    }

    @Test
    fun `a sentence ends with a full stop in every language`() = forEachTranslation { one, other ->
        if (one.endsWith('.') && !other.endsWith('.')) {
            "does not end as \"$one\""
        } else {
            null
        }
    }

    @Test
    fun `nothing is shouted, nobody is kept at a distance and nothing is misspelt by a computer`() {
        val all = (others + (Language.ENGLISH to english)).flatMap { (language, texts) ->
            texts.map { (key, text) -> Triple(language, key, text) }
        }
        val wrong = all.flatMap { (language, key, text) ->
            UNWANTED.filter { it.containsMatchIn(text) }.map { "$key in $language has ${it.pattern}: $text" }
        }
        assertEquals(emptyList(), wrong)
    }

    private fun forEachTranslation(wrongIn: (english: String, other: String) -> String?) {
        val wrong = others.flatMap { (language, texts) ->
            english.mapNotNull { (key, text) ->
                texts[key]?.let { other -> wrongIn(text, other)?.let { "$key in $language $it: $other" } }
            }
        }
        assertEquals(emptyList(), wrong)
    }

    private fun argumentsIn(text: String) = ARGUMENT.findAll(text).map { it.value }.toSet()

    private fun stringsOf(language: Language): Map<String, String> = catalogues.flatMap { (file, messages) ->
        messages.mapNotNull { message ->
            val lines = message.lines()
            val first = lines.indexOfFirst { it.startsWith("- ${language.tag}:") }
            if (first < 0) return@mapNotNull null
            val more = lines.drop(first + 1).takeWhile { it.startsWith("  ") }.map { it.trim() }
            val text = (listOf(lines[first].substringAfter(": ").trim()) + more).joinToString(" ")
            "$file ${lines.first()}" to text
        }
    }.toMap()

    private companion object {
        /** The messages of each catalogue of the screens, each with its heading and all its languages. */
        val catalogues: Map<String, List<String>> = checkNotNull(File("..").listFiles())
            .filter { it.name.startsWith("ui") || it.name == "editing" }
            .flatMap { checkNotNull(File(it, "src/commonMain/messages").listFiles()).asList() }
            .filter { "# object" in it.readText() }
            .associate { it.name to it.readText().split("\n## ").drop(1) }

        /** The longest text of a button, in letters, and how much longer it and a sentence may be in one language. */
        const val BUTTON = 24
        const val BUTTON_ROOM = 1.6
        const val SENTENCE_ROOM = 1.4
        const val FEW = 5

        /** Phrases that are said of different things, in other cases or numbers, or on a small button. */
        val SEVERAL_MEANINGS = setOf(
            "a block",
            "a robot",
            "bring it back",
            "cannot be used",
            "move down",
            "move up",
            "partly solved",
            "try it",
            "turn left",
            "turn right",
        )
        val ARGUMENT = Regex("""\{\w+(?=\}|, plural)""")
        val UNWANTED = listOf(
            "!",
            "¡",
            "  ",
            """ \.( |$)""",
            """\bustedes?\b""",
            """\bIhnen\b""",
            """\bTODO\b""",
            """\\""",
        ).map(::Regex)

        /** Words that English shares with another language, names and units: texts of only these may be identical. */
        val SHARED_WORDS = setOf(
            "On",
            "Off",
            "View",
            "Prgm",
            "Run",
            "Enter",
            "Escape",
            "s",
            "cm",
            "C",
            "Aa",
            "Java",
            "Link",
            "Motor",
            "Name",
            "Links",
            "Note",
            "Solution",
            "Port",
            "Angle",
            "Cutebot",
            "Pro",
            "Maqueen",
            "Plus",
            "Tiny",
            "bit",
            "Kitronik",
            "MOVE",
            "micro",
            "Buggy",
            "Servos",
            "logo",
            "Centre",
            "Menu",
            "Pause",
            "Robot",
            "Seed",
            "Sensor",
            "Tasks",
            "Threads",
            "Variables",
            "Version",
            "firmware",
            "Bluetooth",
            "orange",
            "Radius",
            "Text",
            "bytes",
        )
        val WORD = Regex("\\p{L}+")
    }
}
