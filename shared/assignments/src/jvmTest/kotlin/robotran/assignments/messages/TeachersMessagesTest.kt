package robotran.assignments.messages

import robotran.language.Language
import java.lang.reflect.Method
import java.lang.reflect.Modifier
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertTrue

/** Tests all messages for teachers in all languages. Reflection finds them, so none is missed. */
class TeachersMessagesTest {
    private val tables: Map<Class<*>, (Language) -> Any> = mapOf(
        CollectingMessages::class.java to CollectingMessages::of,
        GradingMessages::class.java to GradingMessages::of,
        ReportMessages::class.java to ReportMessages::of,
    )
    private val messages = tables.keys.flatMap { it.methods.toList() }
        .filter { Modifier.isAbstract(it.modifiers) && it.returnType == String::class.java }

    @Test
    fun `all languages name the same arguments`() {
        assertTrue(messages.size > 40, "${messages.size} messages")
        val wrong = messages.flatMap { message ->
            val markers = argumentsOf(message).flatMap { if (it is List<*>) it else listOf(it) }.map { "$it" }
            val english = described(message, Language.ENGLISH)
            (Language.entries - Language.ENGLISH).flatMap { language ->
                val other = described(message, language)
                markers.filter { (it in english) != (it in other) }.map { "${message.name} in $language: $other" }
            }
        }
        assertEquals(emptyList(), wrong)
    }

    @Test
    fun `no message is in English in another language, and all end alike`() {
        val wrong = messages.filter { message ->
            val described = Language.entries.map { described(message, it) }
            described.drop(1).any { it == described.first() } || described.map { it.endsWith('.') }.toSet().size > 1
        }.map { it.name }
        assertEquals(emptyList(), wrong)
        for (language in Language.entries) {
            assertEquals(13, ReportMessages.of(language).columns(worlds = 2).distinct().size)
        }
    }

    private fun described(message: Method, language: Language): String {
        val table = tables.getValue(message.declaringClass)(language)
        return message.invoke(table, *argumentsOf(message).toTypedArray()) as String
    }

    private fun argumentsOf(message: Method): List<Any> = message.parameterTypes.mapIndexed { number, type ->
        when {
            type.isEnum -> type.enumConstants.first()
            type == String::class.java -> "marker$number"
            type == Int::class.javaPrimitiveType -> 7001 + number
            type == List::class.java -> listOf("marker$number-a", "marker$number-b")
            else -> error("No argument of type $type is known.")
        }
    }
}
