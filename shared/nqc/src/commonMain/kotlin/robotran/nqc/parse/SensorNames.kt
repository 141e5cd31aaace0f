package robotran.nqc.parse

import robotran.language.source.SourceFix
import robotran.nqc.diagnostic.NqcDiagnosticCode
import robotran.nqc.syntax.Token

/**
 * The names that sensors have in other versions and languages.
 *
 * @param words the macros: the sensors are among them.
 */
internal class SensorNames(private val reader: TokenReader, private val words: Set<String>) {
    /** What the sensor [written] is called, such as `IN_1` of the first NQC; null if it is none. */
    fun nameFor(written: String): String? = OTHER_NAME.matchEntire(written)?.let { SENSOR + it.groupValues[1] }

    /** Fails if [name] is called with a sensor alone in the brackets, which open here: its name is its value. */
    fun failAtCall(name: Token) {
        if (name.text !in CALLS) return
        val first = reader.peek(1)
        val use = first.macro?.outermost
        val around = name.macro?.outermost
        val written = if (use === around) first.text else use?.name.orEmpty()
        val right = ARGUMENT.matchEntire(written)?.let { SENSOR + it.groupValues[1] }
        val end = (2..LONGEST_MACRO).map(reader::peek).firstOrNull { it.macro?.outermost !== use || use === around }
        if (right !in words || right == null || end?.isSign(")") != true) return
        val range = name.range.to(end.range)
        val fix = SourceFix(range, right).takeIf { name.macro == null && range.endColumn > name.range.endColumn }
        val message = reader.sink.messages.sensorByName(right)
        reader.fail(NqcDiagnosticCode.UNDEFINED_FUNCTION, name.range, message, fix)
    }

    private companion object {
        const val SENSOR = "SENSOR_"
        val OTHER_NAME = Regex("IN_([0-9])")

        /** Calls that give the value of a sensor in other languages, and what they call it. */
        val CALLS = setOf("Sensor", "SENSOR", "sensor", "ReadSensor", "GetSensor")
        val ARGUMENT = Regex("(?:IN_|S|SENSOR_)?([1-3])")

        /** Max tokens of what a sensor stands for. */
        const val LONGEST_MACRO = 20
    }
}
