package robotran.tinyvm.link

import robotran.tinyvm.classfile.AccessFlag
import robotran.tinyvm.messages.LinkMessages

/**
 * Checks an instruction, applies its effect to a [FrameState] and records in [code] what the instruction names. It does
 * not follow branches.
 */
internal class TransferFunctions(
    method: LinkedMethod,
    private val types: TypeTable,
    private val relations: TypeRelations,
    messages: LinkMessages,
    private val code: ResolvedCode,
    isExact: Boolean,
) {
    private val simpleInstructions = simpleInstructions(isExact)
    private val constants = method.owner.file.constants
    private val resolver = Resolver(constants, types, messages, isExact)
    private val members = MemberTransferFunctions(method, types, relations, resolver, code)
    private val literals = ConstantTransferFunctions(constants, types, messages, code)
    private val arrays = ArrayTransferFunctions(relations, resolver, code)

    fun apply(instruction: Instruction, frameState: FrameState, location: CodeLocation) {
        val simple = simpleInstructions[instruction.opcode]
        when {
            simple != null -> {
                for (letter in simple.takes.reversed()) frameState.popValue(VerificationType.ofLetter(letter))
                for (letter in simple.gives) frameState.pushValue(VerificationType.ofLetter(letter))
            }

            instruction.opcode in Opcode.IALOAD..Opcode.SALOAD ||
                instruction.opcode in Opcode.IASTORE..Opcode.SASTORE -> {
                arrays.element(instruction.opcode, frameState)
            }

            instruction.opcode in Opcode.POP..Opcode.SWAP -> StackShuffles.apply(instruction.opcode, frameState)
            instruction.opcode in Opcode.GETSTATIC..Opcode.PUTFIELD -> members.field(instruction, frameState, location)

            instruction.opcode in Opcode.INVOKEVIRTUAL..Opcode.INVOKEINTERFACE -> {
                members.call(instruction, frameState, location)
            }

            else -> other(instruction, frameState, location)
        }
    }

    private fun other(instruction: Instruction, frameState: FrameState, location: CodeLocation) {
        val operand = instruction.operand
        when (instruction.opcode) {
            Opcode.ACONST_NULL -> frameState.push(VerificationType.NULL)
            Opcode.BIPUSH, Opcode.SIPUSH -> frameState.push(VerificationType.INT)
            Opcode.LDC, Opcode.LDC2_W -> literals.apply(instruction, frameState, location)

            in Opcode.ILOAD..Opcode.ALOAD, in Opcode.ISTORE..Opcode.ASTORE, Opcode.IINC -> {
                LocalTransferFunctions.apply(instruction, frameState)
            }

            Opcode.TABLESWITCH, Opcode.LOOKUPSWITCH -> frameState.popValue(VerificationType.INT)
            in Opcode.IFEQ..Opcode.IFLE -> frameState.popValue(VerificationType.INT)
            in Opcode.IF_ICMPEQ..Opcode.IF_ICMPLE -> repeat(2) { frameState.popValue(VerificationType.INT) }
            Opcode.IF_ACMPEQ, Opcode.IF_ACMPNE -> repeat(2) { frameState.popReference() }
            Opcode.IFNULL, Opcode.IFNONNULL, Opcode.MONITORENTER, Opcode.MONITOREXIT -> frameState.popReference()

            Opcode.NEW -> {
                val type = resolver.classType(operand, location)
                if (type.isInterface || type.file.flags and AccessFlag.ABSTRACT != 0) unsound()
                named(instruction, type)
                frameState.push(VerificationType.reference(type))
            }

            Opcode.NEWARRAY, Opcode.ANEWARRAY, Opcode.MULTIANEWARRAY, Opcode.ARRAYLENGTH -> {
                arrays.apply(instruction, frameState, location)
            }

            Opcode.ATHROW -> if (!relations.fits(frameState.pop(), types.throwable)) unsound()

            Opcode.CHECKCAST -> {
                frameState.popReference()
                frameState.push(VerificationType.reference(named(instruction, resolver.testedType(operand, location))))
            }

            Opcode.INSTANCEOF -> {
                frameState.popReference()
                named(instruction, resolver.testedType(operand, location))
                frameState.push(VerificationType.INT)
            }

            in Opcode.IRETURN..Opcode.RETURN -> members.result(instruction.opcode, frameState, location)
        }
    }

    private fun named(instruction: Instruction, type: HeapType): HeapType {
        code.types[instruction.place] = type
        return type
    }
}
