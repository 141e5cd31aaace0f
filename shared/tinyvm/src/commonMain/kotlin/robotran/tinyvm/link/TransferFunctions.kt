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
) {
    private val constants = method.owner.file.constants
    private val resolver = Resolver(constants, types, messages)
    private val members = MemberTransferFunctions(method, types, relations, resolver, code)
    private val literals = ConstantTransferFunctions(constants, types, messages)
    private val arrays = ArrayTransferFunctions(relations, resolver, code)

    fun apply(instruction: Instruction, situation: FrameState, place: CodeLocation) {
        val simple = SIMPLE_INSTRUCTIONS[instruction.opcode]
        when {
            simple != null -> {
                for (letter in simple.takes.reversed()) situation.popValue(VerificationType.ofLetter(letter))
                for (letter in simple.gives) situation.pushValue(VerificationType.ofLetter(letter))
            }

            instruction.opcode in Opcode.IALOAD..Opcode.SALOAD ||
                instruction.opcode in Opcode.IASTORE..Opcode.SASTORE -> {
                arrays.element(instruction.opcode, situation)
            }

            instruction.opcode in Opcode.POP..Opcode.SWAP -> {
                StackShuffles.apply(instruction.opcode, situation)
            }

            instruction.opcode in Opcode.GETSTATIC..Opcode.PUTFIELD -> {
                members.field(instruction, situation, place)
            }

            instruction.opcode in Opcode.INVOKEVIRTUAL..Opcode.INVOKEINTERFACE -> {
                members.call(instruction, situation, place)
            }

            else -> {
                other(instruction, situation, place)
            }
        }
    }

    private fun other(instruction: Instruction, situation: FrameState, place: CodeLocation) {
        val operand = instruction.operand
        when (instruction.opcode) {
            Opcode.ACONST_NULL -> {
                situation.push(VerificationType.NULL)
            }

            Opcode.BIPUSH, Opcode.SIPUSH -> {
                situation.push(VerificationType.WHOLE)
            }

            Opcode.LDC, Opcode.LDC2_W -> {
                literals.apply(instruction, situation, place)
            }

            in Opcode.ILOAD..Opcode.ALOAD, in Opcode.ISTORE..Opcode.ASTORE, Opcode.IINC -> {
                LocalTransferFunctions.apply(instruction, situation)
            }

            in Opcode.IFEQ..Opcode.IFLE -> {
                situation.popValue(VerificationType.WHOLE)
            }

            in Opcode.IF_ICMPEQ..Opcode.IF_ICMPLE -> {
                repeat(2) { situation.popValue(VerificationType.WHOLE) }
            }

            Opcode.IF_ACMPEQ, Opcode.IF_ACMPNE -> {
                repeat(2) { situation.popReference() }
            }

            Opcode.IFNULL, Opcode.IFNONNULL, Opcode.MONITORENTER, Opcode.MONITOREXIT -> {
                situation.popReference()
            }

            Opcode.NEW -> {
                val type = resolver.testedType(operand, place)
                if (type.isInterface || type.file.flags and AccessFlag.ABSTRACT != 0) unsound()
                named(instruction, type)
                situation.push(VerificationType.reference(type))
            }

            Opcode.NEWARRAY, Opcode.ANEWARRAY, Opcode.MULTIANEWARRAY, Opcode.ARRAYLENGTH -> {
                arrays.apply(instruction, situation, place)
            }

            Opcode.ATHROW -> {
                if (!relations.fits(situation.pop(), types.throwable)) unsound()
            }

            Opcode.CHECKCAST -> {
                situation.popReference()
                situation.push(VerificationType.reference(named(instruction, resolver.testedType(operand, place))))
            }

            Opcode.INSTANCEOF -> {
                situation.popReference()
                named(instruction, resolver.testedType(operand, place))
                situation.push(VerificationType.WHOLE)
            }

            in Opcode.IRETURN..Opcode.RETURN -> {
                members.result(instruction.opcode, situation, place)
            }
        }
    }

    private fun named(instruction: Instruction, type: HeapType): HeapType {
        code.types[instruction.place] = type
        return type
    }
}
