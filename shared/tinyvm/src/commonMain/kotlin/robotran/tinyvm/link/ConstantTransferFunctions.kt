package robotran.tinyvm.link

import robotran.tinyvm.classfile.Constant
import robotran.tinyvm.classfile.ConstantPool
import robotran.tinyvm.config.TinyVmLimits
import robotran.tinyvm.messages.Counted
import robotran.tinyvm.messages.LinkMessages
import robotran.tinyvm.messages.UnsupportedFeature

/** The effects on a [FrameState] of instructions that push a constant of the pool. */
internal class ConstantTransferFunctions(
    private val constants: ConstantPool,
    private val types: TypeTable,
    private val messages: LinkMessages,
) {
    fun apply(instruction: Instruction, situation: FrameState, place: CodeLocation) {
        val wide = instruction.opcode == Opcode.LDC2_W
        when (val constant = constants.constant(instruction.operand)) {
            is Constant.Whole -> {
                situation.push(VerificationType.WHOLE)
            }

            is Constant.Decimal -> {
                situation.push(VerificationType.DECIMAL)
            }

            is Constant.Long -> {
                situation.pushValue(VerificationType.LONG)
            }

            is Constant.Double -> {
                situation.pushValue(VerificationType.DOUBLE)
            }

            is Constant.StringText -> {
                if (constants.string(constant).length > TinyVmLimits.STRING_CHARACTERS) {
                    place.refuse(messages.tooMany(Counted.TEXT_CHARACTERS, TinyVmLimits.STRING_CHARACTERS))
                }
                situation.push(VerificationType.reference(types.text))
            }

            is Constant.ClassName -> {
                place.refuse(messages.lacks(UnsupportedFeature.CLASS_LITERAL))
            }

            else -> {
                unsound()
            }
        }
        val isWide = constants.constant(instruction.operand).let { it is Constant.Long || it is Constant.Double }
        if (isWide != wide) unsound()
    }
}
