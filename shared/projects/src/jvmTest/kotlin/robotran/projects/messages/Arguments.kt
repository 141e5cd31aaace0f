package robotran.projects.messages

import robotran.brick.program.ProgramFailure
import robotran.language.pasted.PastedCharacter
import robotran.language.pasted.pastedCharacter
import robotran.simulation.messages.Mover
import robotran.simulation.messages.PaperSector
import robotran.simulation.messages.Region
import java.lang.reflect.Method
import java.lang.reflect.ParameterizedType
import java.lang.reflect.Type
import java.lang.reflect.WildcardType

/**
 * The arguments for calls of a message: every text is another marker and every number unique; all enum entries, both
 * flags, and null for optional arguments occur, but not all nulls at once.
 */
internal fun argumentsOf(message: Method): List<List<Any?>> {
    val choices = message.genericParameterTypes.mapIndexed { number, type -> choicesOf(type, number) }
    return choices.fold(listOf(emptyList<Any?>())) { begun, next -> begun.flatMap { some -> next.map { some + it } } }
        .filter { arguments -> arguments.isEmpty() || arguments.any { it != null } }.take(MAX_CALLS)
}

/** The texts and numbers in [arguments] that can be found again in a sentence. */
internal fun markersIn(arguments: List<Any?>): List<String> = arguments.flatMap { argument ->
    when (argument) {
        is String -> listOf(argument)
        is Int -> if (argument >= LARGE) listOf("$argument", argument.toString(radix = 16)) else emptyList()
        is Long -> if (argument >= LARGE) listOf("$argument") else emptyList()
        is Collection<*> -> markersIn(argument.toList())
        is Region -> listOfNotNull(argument.name)
        is Mover.OtherRobot -> listOf(argument.name)
        is Mover.Block -> listOf(argument.name)
        is ProgramFailure -> markersIn(listOf(argument.message, argument.sourceLine, argument.sourceFile))
        else -> emptyList()
    }
}

private fun choicesOf(type: Type, number: Int): List<Any?> = when (type) {
    String::class.java -> listOf(marker(number), null)
    Int::class.javaPrimitiveType -> listOf(LARGE + number, 1, 0)
    Int::class.javaObjectType -> listOf(LARGE + number, 1, null)
    Long::class.javaPrimitiveType -> listOf(LARGE.toLong() + number)
    Double::class.javaPrimitiveType -> listOf(0.5, 1.0, 2.5)
    Boolean::class.javaPrimitiveType -> listOf(true, false)
    Mover::class.java -> listOf(Mover.OwnRobot, Mover.OtherRobot("marker-robot"), Mover.Block("marker-block"))

    Region::class.java -> listOf(Region("marker-region", PaperSector.TOP)) +
        PaperSector.entries.map { Region(null, it) }

    ProgramFailure::class.java -> listOf(null, "marker-file").map {
        ProgramFailure("marker-failure.", LARGE, sourceFile = it)
    }

    PastedCharacter::class.java -> PASTED.map { checkNotNull(pastedCharacter(it)) }
    is WildcardType -> choicesOf(type.upperBounds.single(), number)

    is ParameterizedType -> if (type.rawType == Map::class.java) {
        mapsOf(type, number)
    } else {
        listsOf(type.actualTypeArguments.single(), number)
    }

    is Class<*> -> type.enumConstants?.toList() ?: error("No argument of type $type is known.")
    else -> error("No argument of type $type is known.")
}

/** Maps with one entry for each key and value, and with all keys. */
private fun mapsOf(type: ParameterizedType, number: Int): List<Map<Any?, Any?>> {
    val (keys, values) = type.actualTypeArguments.map { choicesOf(it, number) }
    return keys.flatMap { key -> values.map { mapOf(key to it) } } +
        values.map { value -> keys.associateWith { value } }
}

private fun listsOf(type: Type, number: Int): List<List<Any?>> {
    val some = choicesOf(type, number).filterNotNull()
    return if (type == String::class.java) {
        listOf(listOf("${marker(number)}-a", "${marker(number)}-b", "${marker(number)}-c"), listOf(marker(number)))
    } else {
        listOf(some.take(2), some.take(1), some)
    }
}

private fun marker(number: Int) = "marker$number"

/** No sentence contains a number from here on by itself. */
private const val LARGE = 7001
private const val MAX_CALLS = 500

/** One of each kind: a quotation mark, a dash, a sign, a wide letter, a space, a line break, and one that is not seen. */
private const val PASTED = "\u201C\u2013\u2264\uFF21\u2003\u2028\u200B"
