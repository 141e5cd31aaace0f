package robotran.tinyvm.link

import robotran.tinyvm.classfile.Constant
import robotran.tinyvm.config.TinyVmLimits
import robotran.tinyvm.messages.Counted
import robotran.tinyvm.messages.LinkMessages
import robotran.tinyvm.messages.UnsupportedFeature

/**
 * Checks an instruction, applies its effect to a [FrameState] and records in [code] what the instruction names. It does
 * not follow branches.
 */
internal class TransferFunctions(
    private val method: LinkedMethod,
    private val types: TypeTable,
    private val relations: TypeRelations,
    private val messages: LinkMessages,
    private val code: ResolvedCode,
) {
    private val constants = method.owner.file.constants
    private val resolver = Resolver(constants, types, messages)
    private val members = MemberTransferFunctions(method, types, relations, resolver, code)
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
            ACONST_NULL -> {
                situation.push(VerificationType.NULL)
            }

            BIPUSH, SIPUSH -> {
                situation.push(VerificationType.WHOLE)
            }

            Opcode.LDC, Opcode.LDC2_W -> {
                constant(instruction, situation, place)
            }

            in Opcode.ILOAD until Opcode.ALOAD -> {
                val kind = VerificationType.ofLetter(KINDS[instruction.opcode - Opcode.ILOAD])
                if (situation.local(operand) != kind) unsound()
                if (VerificationType.isWide(kind) &&
                    situation.local(operand + 1) != VerificationType.SECOND_WORD
                ) {
                    unsound()
                }
                situation.pushValue(kind)
            }

            Opcode.ALOAD -> {
                situation.push(situation.local(operand).also { if (!VerificationType.isReference(it)) unsound() })
            }

            in Opcode.ISTORE until Opcode.ASTORE -> {
                val kind = VerificationType.ofLetter(KINDS[instruction.opcode - Opcode.ISTORE])
                situation.popValue(kind)
                situation.setLocal(operand, kind)
            }

            Opcode.ASTORE -> {
                val value = situation.pop()
                if (!VerificationType.isReference(value) && !VerificationType.isReturnAddress(value)) unsound()
                situation.setLocal(operand, value)
            }

            Opcode.IINC -> {
                if (situation.local(operand) != VerificationType.WHOLE) unsound()
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
                if (type.isInterface || type.file.flags and ABSTRACT != 0) unsound()
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

    private fun constant(instruction: Instruction, situation: FrameState, place: CodeLocation) {
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

    private fun named(instruction: Instruction, type: HeapType): HeapType = type.also {
        code.types[instruction.place] =
            it
    }

    private companion object {
        const val ACONST_NULL = 1
        const val BIPUSH = 16
        const val SIPUSH = 17
        const val ABSTRACT = 0x0400

        /** The types of the load and store instructions, in opcode order. */
        const val KINDS = "IJFD"
    }
}
