package robotran.legofirmware.listing

import robotran.legofirmware.instructions.Instruction
import robotran.legofirmware.instructions.Operand
import robotran.legofirmware.instructions.OperandKind
import robotran.legofirmware.instructions.ValueSource

private const val TOP_BITS = 6
private const val MODE_BITS = 5
private val motorLetters = listOf(1 to 'A', 2 to 'B', 4 to 'C')
private val outputModes = listOf("Float", "Off", "On", "?")
private val directions = listOf("Rev", "Flip", "Fwd", "?")
private val sensorTypes = listOf("None", "Switch", "Temp", "Light", "Angle")

/** As the original spells them. */
private val sensorModes =
    listOf("Raw", "Boolean", "Edge", "Pulse", "Percent", "Celcius", "Fahrenheit", "Angle")

/** The operands of an instruction as in a plain listing, separated by commas. */
internal fun Instruction.plainOperands(): String {
    val kinds = opcode.operands.filter { it != OperandKind.ZERO }
    return operands.zip(kinds).joinToString(", ") { (operand, kind) -> plainText(operand, kind) }
}

private fun plainText(operand: Operand, kind: OperandKind): String = when (operand) {
    is Operand.Value -> plainValue(operand)
    is Operand.Test -> "${plainValue(operand.left)} ${operand.relation.symbol} ${plainValue(operand.right)}"
    is Operand.Address -> "${operand.address}"
    is Operand.Number -> plainNumber(operand.value, kind)
}

private fun plainNumber(number: Int, kind: OperandKind): String = when (kind) {
    OperandKind.VARIABLE -> "var[$number]"
    OperandKind.MOTORS -> motors(number)
    OperandKind.OUTPUT -> "${motors(number)}, ${outputModes[number shr TOP_BITS]}"
    OperandKind.DIRECTION -> "${motors(number)}, ${directions[number shr TOP_BITS]}"
    OperandKind.SENSOR_TYPE -> sensorTypes.getOrElse(number) { "$number" }
    OperandKind.SENSOR_MODE -> sensorModes[number shr MODE_BITS]
    OperandKind.WORD -> "${number.toShort()}"
    else -> "$number"
}

private fun motors(mask: Int): String =
    motorLetters.filter { (bit, _) -> mask and bit != 0 }.joinToString("") { (_, letter) -> "$letter" }.ifEmpty { "0" }

private fun plainValue(value: Operand.Value): String = when (val source = ValueSource.of(value.source)) {
    ValueSource.CONSTANT -> "${value.argument}"
    ValueSource.VARIABLE, ValueSource.INDIRECT, ValueSource.UART -> "${source.listingName}[${value.argument}]"

    null -> if (value.source > ValueSource.GREATEST_CODE) {
        "?(${value.argument})"
    } else {
        "%${value.source}(${value.argument})"
    }

    else -> "${source.listingName}(${value.argument})"
}
