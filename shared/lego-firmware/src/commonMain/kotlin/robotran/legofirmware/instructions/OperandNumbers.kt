package robotran.legofirmware.instructions

/** The numbers that stand for an operand in assembly text. */
object OperandNumbers {
    private const val TOP_BITS = 6
    private const val MOTOR_MASK = 7
    private const val MODE_BITS = 5
    private const val SLOPE_MASK = 0x1F
    private const val TOP_MODE = 3
    private const val GREATEST_MODE = 7

    private val byte = NumberRange.BYTE
    private val mask = NumberRange("mask", 0..MOTOR_MASK)
    private val source = NumberRange("source", NumberRange.BYTE.range)
    private val argument = NumberRange("argument", -0x8000..0xFFFF)

    /** The names and ranges of the numbers of an operand of this [kind]; empty for an address. */
    fun rangesOf(kind: OperandKind): List<NumberRange> = when (kind) {
        OperandKind.VALUE -> listOf(source, argument)
        OperandKind.BYTE_VALUE, OperandKind.PLACE -> listOf(source, NumberRange("argument", byte.range))

        OperandKind.TEST -> listOf(
            NumberRange("source", 0..0x3F),
            argument,
            NumberRange("relation", 0..Relation.entries.lastIndex),
            source,
            NumberRange("argument", byte.range),
        )

        OperandKind.VARIABLE -> listOf(NumberRange("variable", byte.range))
        OperandKind.MOTORS -> listOf(mask)
        OperandKind.OUTPUT -> listOf(mask, NumberRange("mode", 0..TOP_MODE))
        OperandKind.DIRECTION -> listOf(NumberRange("direction", 0..TOP_MODE), mask)
        OperandKind.SENSOR -> listOf(NumberRange("sensor", byte.range))
        OperandKind.SENSOR_TYPE -> listOf(NumberRange("type", byte.range))
        OperandKind.SENSOR_MODE -> listOf(NumberRange("mode", 0..GREATEST_MODE), NumberRange("slope", 0..SLOPE_MASK))
        OperandKind.BYTE -> listOf(byte)
        OperandKind.WORD -> listOf(NumberRange("number", -0x8000..0xFFFF))
        else -> emptyList()
    }

    /** The numbers of an [operand] of this [kind]; bits that have no meaning are left out. */
    fun of(operand: Operand, kind: OperandKind): List<Int> = when (operand) {
        is Operand.Value -> listOf(operand.source, operand.argument)

        is Operand.Test -> {
            listOf(
                operand.left.source,
                operand.left.argument,
                operand.relation.code,
                operand.right.source,
                operand.right.argument,
            )
        }

        is Operand.Address -> emptyList()

        is Operand.Number -> {
            val number = operand.value
            when (kind) {
                OperandKind.MOTORS -> listOf(number and MOTOR_MASK)
                OperandKind.OUTPUT -> listOf(number and MOTOR_MASK, number shr TOP_BITS)
                OperandKind.DIRECTION -> listOf(number shr TOP_BITS, number and MOTOR_MASK)
                OperandKind.SENSOR_MODE -> listOf(number shr MODE_BITS, number and SLOPE_MASK)
                else -> listOf(number)
            }
        }
    }

    /** The operand of this [kind] that has [numbers], each within its range. Not for an address. */
    fun toOperand(numbers: List<Int>, kind: OperandKind): Operand = when (kind) {
        OperandKind.VALUE -> Operand.Value(numbers[0], numbers[1].toShort().toInt())
        OperandKind.BYTE_VALUE, OperandKind.PLACE -> Operand.Value(numbers[0], numbers[1])

        OperandKind.TEST -> Operand.Test(
            Relation.of(numbers[2]),
            Operand.Value(numbers[0], numbers[1].toShort().toInt()),
            Operand.Value(numbers[RIGHT_SOURCE], numbers[RIGHT_ARGUMENT]),
        )

        OperandKind.OUTPUT -> Operand.Number(numbers[1] shl TOP_BITS or numbers[0])
        OperandKind.DIRECTION -> Operand.Number(numbers[0] shl TOP_BITS or numbers[1])
        OperandKind.SENSOR_MODE -> Operand.Number(numbers[0] shl MODE_BITS or numbers[1])
        OperandKind.WORD -> Operand.Number(numbers[0] and 0xFFFF)
        else -> Operand.Number(numbers[0])
    }

    private const val RIGHT_SOURCE = 3
    private const val RIGHT_ARGUMENT = 4
}

/**
 * A number in assembly text.
 *
 * @property name of the number in the form of a command, such as `source`.
 */
data class NumberRange(val name: String, val range: IntRange) {
    companion object {
        val BYTE = NumberRange("number", 0..0xFF)
    }
}
