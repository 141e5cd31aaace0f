package robotran.javacompiler.diagnose

import robotran.language.source.SourceFix
import robotran.lejoslibrary.LejosRemedy

/**
 * The change that puts what leJOS has into the place of what it lacks, from [start] to before [end] of [source]. Null if
 * that takes more than a change in this place.
 *
 * @param member the name of the member that is lacking; empty for a class.
 */
internal fun lejosFix(remedy: LejosRemedy, member: String, start: Int, end: Int, source: SourceText): SourceFix? {
    val words = source.words(start, end)
    if (words.length < end - start) return null
    return when (remedy) {
        LejosRemedy.STRING_BUFFER -> {
            SourceFix(source.range(start, end), "StringBuffer").takeIf { words == "StringBuilder" }
        }

        LejosRemedy.SENSOR_CONSTANTS -> {
            SourceFix(source.range(start - SENSOR.length - 1, end), "SensorConstants.$member")
                .takeIf { source.qualifier(start) == SENSOR }
        }

        LejosRemedy.EXCEPTION_WITHOUT_TEXT -> {
            SourceFix(source.range(start, end), "${words.substringBefore('(')}()")
                .takeIf { words.startsWith("new ") && words.endsWith(')') }
        }

        LejosRemedy.INTEGER_TO_STRING -> charactersFix(start, source, "Integer.toString(", ").toCharArray()")

        LejosRemedy.APPEND_TO_STRING_BUFFER -> {
            charactersFix(start, source, "new StringBuffer(20).append(", ").getChars()")
        }

        LejosRemedy.EXCEPTION_WITH_TEXT -> {
            SourceFix(source.range(start, end), "${words.substringBefore('(')}(\"\")")
                .takeIf { words.startsWith("new ") && words.endsWith(')') }
        }

        LejosRemedy.SEND_BYTES -> SourceFix(source.range(start, end), "sendBytes").takeIf { words == member }

        LejosRemedy.CHECKED_EXCEPTION,
        LejosRemedy.LAST_INDEX_OF,
        LejosRemedy.SERIAL_PACKETS,
        LejosRemedy.VECTOR,
        LejosRemedy.LOOP_FROM_THE_END,
        LejosRemedy.LEAVE_OUT,
        LejosRemedy.PACKAGE_OF_2_1,
        -> {
            null
        }
    }
}

/**
 * Puts the argument of `StringUtils.getCharacters`, whose name begins at [start], between [before] and [after]; null if the
 * call looks otherwise or does not end on its line.
 */
private fun charactersFix(start: Int, source: SourceText, before: String, after: String): SourceFix? {
    if (source.qualifier(start) != STRING_UTILS) return null
    val from = start - STRING_UTILS.length - 1
    val call = source.snippetUntil(from, ';')
    if (!call.startsWith(CHARACTERS)) return null
    var depth = 0
    val close = call.indices.firstOrNull { index ->
        if (call[index] == '(') depth++
        if (call[index] == ')') depth--
        depth == 0 && call[index] == ')'
    } ?: return null
    val argument = call.substring(CHARACTERS.length, close)
    return SourceFix(source.range(from, from + close + 1), before + argument + after)
}

private const val SENSOR = "Sensor"
private const val STRING_UTILS = "StringUtils"
private const val CHARACTERS = "$STRING_UTILS.getCharacters("
