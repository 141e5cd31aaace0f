package robotran.nqc.generate

import robotran.language.source.SourceRange
import robotran.legofirmware.instructions.Opcode
import robotran.legofirmware.instructions.ValueSource
import robotran.nqc.tree.Expression
import robotran.nqc.tree.OperatorKind
import robotran.nqc.tree.Place
import robotran.nqc.tree.sourceOf

/** Which sensors the code of a program compares with numbers, and which it sets up. */
internal class SensorUse {
    /**
     * The first comparison of a sensor.
     *
     * @property port from 0.
     * @property isTouch whether it is one with 0 or 1.
     */
    class Comparison(val port: Int, val isTouch: Boolean, val range: SourceRange)

    private val comparisons = LinkedHashMap<Int, Comparison>()
    private val setUp = mutableSetOf<Int>()

    /** The first comparison of each sensor of which nothing says what it is. */
    val unset: List<Comparison> get() = comparisons.values.filter { it.port !in setUp }

    /** Notes the comparisons in [expression], whose variables have their places. */
    fun note(expression: Expression) {
        if (expression is Expression.Binary && expression.operator.kind == OperatorKind.COMPARISON) compare(expression)
        expression.parts.forEach { note(it) }
    }

    private fun compare(comparison: Expression.Binary) {
        val sides = listOf(comparison.left, comparison.right)
        val number = sides.firstNotNullOfOrNull { it.constant }?.takeIf { it in PERCENT } ?: return
        val sensor = sides.find { it is Expression.Source }?.let { sourceOf(it) } ?: return
        if (sensor.type != ValueSource.INPUT.code) return
        comparisons.getOrPut(sensor.data) { Comparison(sensor.data, number <= 1, comparison.range) }
    }

    /**
     * Notes what the bytes of an `asm` set up.
     *
     * @param isOwn whether the program has written them, so that they may be several commands.
     */
    fun noteCommand(bytes: List<Int>, isOwn: Boolean) {
        val last = if (isOwn) bytes.lastIndex - 1 else 0
        for (index in 0..minOf(last, bytes.lastIndex - 1)) if (bytes[index] in SETTERS) setUp += bytes[index + 1]
    }

    /** Notes that a command writes to [place]. */
    fun noteTarget(place: Place) {
        if (place.type in SETTINGS) setUp += place.data
    }

    private companion object {
        /** What a sensor gives that is set up; a raw value is hardly ever that small. */
        val PERCENT = 0..100

        val SETTERS = setOf(Opcode.SENT.code, Opcode.SENM.code)
        val SETTINGS = setOf(ValueSource.SENSOR_TYPE.code, ValueSource.SENSOR_MODE.code)
    }
}
