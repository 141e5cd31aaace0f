package robotran.tinyvm.link

import robotran.tinyvm.classfile.Constant
import robotran.tinyvm.classfile.ConstantPool
import robotran.tinyvm.messages.Counted
import robotran.tinyvm.messages.LinkMessages
import robotran.tinyvm.messages.UnsupportedFeature

/** The effects on a [FrameState] of instructions that push a constant of the pool. */
internal class ConstantTransferFunctions(
    private val constants: ConstantPool,
    private val types: TypeTable,
    private val messages: LinkMessages,
    private val code: ResolvedCode,
) {
    fun apply(instruction: Instruction, frameState: FrameState, location: CodeLocation) {
        val wide = instruction.opcode == Opcode.LDC2_W
        when (val constant = constants.constant(instruction.operand)) {
            is Constant.Whole -> frameState.push(VerificationType.INT)
            is Constant.Decimal -> frameState.push(VerificationType.FLOAT)
            is Constant.Long -> frameState.pushValue(VerificationType.LONG)
            is Constant.Double -> frameState.pushValue(VerificationType.DOUBLE)

            is Constant.StringText -> {
                if (constants.string(constant).length > types.model.textCharacters) {
                    location.reject(messages.tooMany(Counted.TEXT_CHARACTERS, types.model.textCharacters))
                }
                frameState.push(VerificationType.reference(types.text))
            }

            is Constant.ClassName -> {
                if (!types.model.isExact) {
                    location.reject(messages.unsupportedFeature(UnsupportedFeature.CLASS_LITERAL))
                }
                code.types[instruction.place] = types.typeNamed(constants.className(instruction.operand), location)
                frameState.push(VerificationType.reference(types.classNamed("java/lang/Class", location)))
            }

            else -> unsound()
        }
        val isWide = constants.constant(instruction.operand).let { it is Constant.Long || it is Constant.Double }
        if (isWide != wide) unsound()
    }
}
