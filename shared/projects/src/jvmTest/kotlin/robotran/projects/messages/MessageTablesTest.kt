package robotran.projects.messages

import robotran.javacompiler.messages.JavaMessages
import robotran.json.messages.JsonMessages
import robotran.language.Language
import robotran.legofirmware.messages.AssemblyMessages
import robotran.legofirmware.messages.FirmwareRunMessages
import robotran.lejoslinker.messages.ImageMessages
import robotran.lejoslinker.messages.ListingMessages
import robotran.nxt.messages.NxtMessages
import robotran.programs.messages.ProgramMessages
import robotran.rcxrom.messages.BrickMessages
import robotran.robolang.messages.RobolangMessages
import robotran.simulation.messages.SimulationMessages
import robotran.tinyvm.messages.TinyVmMessages
import robotran.world.messages.WorldFileMessages
import java.lang.reflect.InvocationTargetException
import java.lang.reflect.Method
import java.lang.reflect.Modifier
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertTrue
import robotran.legofirmware.messages.ImageMessages as RcxImageMessages
import robotran.world.messages.RobotMessages as RobotBuildMessages

/** Checks every message of every table in all languages, found by reflection, so that none can be forgotten. */
class MessageTablesTest {
    @Test
    fun `every message of every table is said`() {
        assertTrue(said.size > 1_000, "${said.size} sentences")
        assertEquals(
            emptyList(),
            tables.keys.flatMap(::messagesOf).filter { message ->
                said.none { it.message == message }
            }.map { it.name },
        )
    }

    @Test
    fun `all languages name the same arguments`() = forEachTranslation { one, english, other ->
        val needed = one.markers.filter { it in english }
        val missing = needed.filter { it !in other }.map { "does not name $it" }
        val added = one.markers.filter { it !in english && it in other }.map { "names $it, which English does not" }
        missing + added
    }

    @Test
    fun `no English sentence is left in another language`() = forEachTranslation { one, english, other ->
        val words = one.markers.fold(english) { text, marker -> text.replace(marker, "") }
        if (english == other && words.any { it.isLetter() } && one.message.name !in SAME_EVERYWHERE &&
            english !in SAME_BY_CHANCE
        ) {
            listOf("is in English")
        } else {
            emptyList()
        }
    }

    @Test
    fun `no two translations are the same`() {
        val same = said.flatMap { one ->
            val others = translations.map { it to one.of(it) }.filter { it.second != one.of(Language.ENGLISH) }
            others.groupBy({ it.second }, { it.first })
                .filter { (text, languages) ->
                    languages.size > 1 &&
                        !(languages.containsAll(ALIKE) && text.length <= SHORT)
                }
                .map { (text, languages) -> "${one.message.name} in $languages: $text" }
        }
        assertEquals(emptyList(), same.distinct())
    }

    @Test
    fun `a sentence ends as in English`() = forEachTranslation { _, english, other ->
        val ends = listOf('.', '?')
        val one = english.lastOrNull().takeIf { it in ends }
        val two = other.lastOrNull().takeIf { it in ends }
        if (one == two) emptyList() else listOf("ends with $two, not with $one")
    }

    @Test
    fun `sentences begin with a capital letter where they do in English`() = forEachTranslation { _, english, other ->
        val isSentence = english.first().isUpperCase() && english.last() == '.'
        if (isSentence && other.first().isLetter() && !other.first().isUpperCase()) {
            listOf("begins with a small letter")
        } else {
            emptyList()
        }
    }

    @Test
    fun `nothing is shouted, nobody is kept at a distance and nothing is left open`() {
        val wrong = said.flatMap { one ->
            Language.entries.flatMap { language ->
                val text = one.of(language)
                UNWANTED.filter {
                    it.containsMatchIn(text)
                }.map { "${one.message.name} in $language has ${it.pattern}: $text" }
            }
        }
        assertEquals(emptyList(), wrong)
    }

    private fun forEachTranslation(wrongIn: (one: Said, english: String, other: String) -> List<String>) {
        val wrong = said.flatMap { one ->
            translations.flatMap { language ->
                val other = one.of(language)
                wrongIn(one, one.of(Language.ENGLISH), other).map { "${one.message.name} in $language $it: $other" }
            }
        }
        assertEquals(emptyList(), wrong.distinct())
    }

    private companion object {
        val translations = Language.entries - Language.ENGLISH

        val tables: Map<Class<*>, (Language) -> Any> = mapOf(
            RobolangMessages::class.java to RobolangMessages::of,
            BrickMessages::class.java to BrickMessages::of,
            NxtMessages::class.java to NxtMessages::of,
            JavaMessages::class.java to JavaMessages::of,
            TinyVmMessages::class.java to TinyVmMessages::of,
            ImageMessages::class.java to ImageMessages::of,
            ListingMessages::class.java to ListingMessages::of,
            RcxImageMessages::class.java to RcxImageMessages::of,
            AssemblyMessages::class.java to AssemblyMessages::of,
            FirmwareRunMessages::class.java to FirmwareRunMessages::of,
            ProgramMessages::class.java to ProgramMessages::of,
            SimulationMessages::class.java to SimulationMessages::of,
            JsonMessages::class.java to JsonMessages::of,
            WorldFileMessages::class.java to WorldFileMessages::of,
            RobotBuildMessages::class.java to RobotBuildMessages::of,
            ProjectMessages::class.java to ProjectMessages::of,
        )

        /** The ROM's own names of its routines. */
        val SAME_EVERYWHERE = setOf("setUp")

        /** What is right in English and in another language. */
        val SAME_BY_CHANCE = setOf("Use \"if\".", "code")

        /** Languages that share many words, and the longest sentence that they may share, in characters. */
        val ALIKE = listOf(Language.SPANISH, Language.PORTUGUESE)
        const val SHORT = 24

        val UNWANTED = listOf(
            "!",
            "¡",
            "  ",
            " \\.(?!\\.)",
            "\\bnull\\.$",
            "\\bustedes?\\b",
            "\\bIhnen\\b",
            "\\$",
        ).map(::Regex)

        val said: List<Said> by lazy {
            tables.flatMap { (table, of) ->
                messagesOf(table).flatMap { message -> argumentsOf(message).mapNotNull { saidWith(message, it, of) } }
            }
        }

        fun messagesOf(table: Class<*>): List<Method> = table.methods.filter {
            Modifier.isAbstract(it.modifiers) && it.returnType == String::class.java
        }.sortedBy { it.name }

        /** null if these arguments are not allowed: a required one is null, or a number is out of range. */
        fun saidWith(message: Method, arguments: List<Any?>, of: (Language) -> Any): Said? = try {
            Said(
                message,
                markersIn(arguments),
                Language.entries.associateWith {
                    message.invoke(of(it), *arguments.toTypedArray()) as String
                },
            )
        } catch (refusal: InvocationTargetException) {
            if (refusal.cause is NullPointerException || refusal.cause is IndexOutOfBoundsException) {
                null
            } else {
                throw refusal
            }
        }
    }

    /** The texts of [message] for one set of arguments. */
    private class Said(val message: Method, val markers: List<String>, private val texts: Map<Language, String>) {
        fun of(language: Language): String = texts.getValue(language)
    }
}
