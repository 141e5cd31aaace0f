package robotran.cli.messages

import robotran.brick.kind.BrickKind
import robotran.cli.console.messages
import robotran.language.Language
import java.lang.reflect.Method
import java.lang.reflect.Modifier
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertTrue

/** Tests all messages of the command line in all languages. Reflection finds them, so none is missed. */
class CommandMessagesTest {
    private val messages = CommandMessages::class.java.methods.filter {
        Modifier.isAbstract(it.modifiers)
    }.sortedBy { it.name }

    @Test
    fun `all languages name the same arguments`() {
        assertTrue(messages.size > 40, "${messages.size} messages")
        val wrong = messages.flatMap { message ->
            val arguments = argumentsOf(message)
            val markers = arguments.flatMap { if (it is List<*>) it else listOf(it) }.map { "$it" }
            val english = described(message, Language.ENGLISH, arguments)
            (Language.entries - Language.ENGLISH).flatMap { language ->
                val other = described(message, language, arguments)
                markers.filter {
                    (it in english) != (it in other)
                }.map { "${message.name} in $language and $it: $other" }
            }
        }
        assertEquals(emptyList(), wrong)
    }

    @Test
    fun `no message is in English in another language, and all end alike`() {
        val wrong = messages.filter { message ->
            val described = Language.entries.map { described(message, it, argumentsOf(message)) }
            described.drop(1).any { it == described.first() } || described.map { it.endsWith('.') }.toSet().size > 1
        }
        assertEquals(emptyList(), wrong.map { it.name } - SAME_EVERYWHERE)
    }

    private fun described(message: Method, language: Language, arguments: List<Any>): String =
        message.invoke(CommandMessages.of(language), *arguments.toTypedArray()).let {
            if (it is List<*>) it.joinToString() else "$it"
        }

    /** Numbers are below a thousand, since languages group digits in their own ways. */
    private fun argumentsOf(message: Method): List<Any> = message.parameterTypes.mapIndexed { number, type ->
        when (type) {
            String::class.java -> "marker$number"
            Int::class.javaPrimitiveType -> 701 + number
            Long::class.javaPrimitiveType -> 701L + number
            BrickKind::class.java -> BrickKind.default
            List::class.java -> listOf("marker$number-a", "marker$number-b")
            else -> error("No argument of type $type is known.")
        }
    }

    private companion object {
        /** Portuguese says "link", too. */
        val SAME_EVERYWHERE = setOf("numberedLink")
    }
}
