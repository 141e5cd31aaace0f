package robotran.tinyvm.link

import robotran.tinyvm.Counted
import robotran.tinyvm.LackedFeature
import robotran.tinyvm.LinkMessages
import robotran.tinyvm.TinyVmLimits
import robotran.tinyvm.classfile.Constant

/** Works out what an instruction does to a [Situation], checking that it may, and notes what it names in [code]. Branches aside. */
internal class Effects(
    private val method: LinkedMethod,
    private val types: TypeTable,
    private val relations: TypeRelations,
    private val messages: LinkMessages,
    private val code: ResolvedCode,
) {
    private val constants = method.owner.file.constants
    private val resolver = Resolver(constants, types, messages)

    fun apply(instruction: Instruction, situation: Situation, place: Place) {
        val simple = SIMPLE_INSTRUCTIONS[instruction.opcode]
        when {
            simple != null -> {
                for (letter in simple.takes.reversed()) situation.popValue(ValueType.ofLetter(letter))
                for (letter in simple.gives) situation.pushValue(ValueType.ofLetter(letter))
            }

            instruction.opcode in Opcode.IALOAD..Opcode.SALOAD || instruction.opcode in Opcode.IASTORE..Opcode.SASTORE -> {
                element(instruction.opcode, situation)
            }

            instruction.opcode in Opcode.POP..Opcode.SWAP -> {
                StackShuffles.apply(instruction.opcode, situation)
            }

            instruction.opcode in Opcode.GETSTATIC..Opcode.PUTFIELD -> {
                field(instruction, situation, place)
            }

            instruction.opcode in Opcode.INVOKEVIRTUAL..Opcode.INVOKEINTERFACE -> {
                call(instruction, situation, place)
            }

            else -> {
                other(instruction, situation, place)
            }
        }
    }

    private fun other(instruction: Instruction, situation: Situation, place: Place) {
        val operand = instruction.operand
        when (instruction.opcode) {
            ACONST_NULL -> {
                situation.push(ValueType.NULL)
            }

            BIPUSH, SIPUSH -> {
                situation.push(ValueType.WHOLE)
            }

            Opcode.LDC, Opcode.LDC2_W -> {
                constant(instruction, situation, place)
            }

            in Opcode.ILOAD until Opcode.ALOAD -> {
                val kind = ValueType.ofLetter(KINDS[instruction.opcode - Opcode.ILOAD])
                if (situation.local(operand) != kind) unsound()
                if (ValueType.isWide(kind) && situation.local(operand + 1) != ValueType.SECOND_WORD) unsound()
                situation.pushValue(kind)
            }

            Opcode.ALOAD -> {
                situation.push(situation.local(operand).also { if (!ValueType.isReference(it)) unsound() })
            }

            in Opcode.ISTORE until Opcode.ASTORE -> {
                val kind = ValueType.ofLetter(KINDS[instruction.opcode - Opcode.ISTORE])
                situation.popValue(kind)
                situation.setLocal(operand, kind)
            }

            Opcode.ASTORE -> {
                val value = situation.pop()
                if (!ValueType.isReference(value) && !ValueType.isReturnAddress(value)) unsound()
                situation.setLocal(operand, value)
            }

            Opcode.IINC -> {
                if (situation.local(operand) != ValueType.WHOLE) unsound()
            }

            in Opcode.IFEQ..Opcode.IFLE -> {
                situation.popValue(ValueType.WHOLE)
            }

            in Opcode.IF_ICMPEQ..Opcode.IF_ICMPLE -> {
                repeat(2) { situation.popValue(ValueType.WHOLE) }
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
                situation.push(ValueType.reference(type))
            }

            Opcode.NEWARRAY, Opcode.ANEWARRAY -> {
                situation.popValue(ValueType.WHOLE)
                val type = if (instruction.opcode ==
                    Opcode.NEWARRAY
                ) {
                    resolver.numberArray(operand, place)
                } else {
                    resolver.arrayOf(operand, place)
                }
                situation.push(ValueType.reference(named(instruction, type)))
            }

            Opcode.MULTIANEWARRAY -> {
                val type = resolver.type(operand, place)
                if (instruction.second !in 1..type.descriptor.takeWhile { it == '[' }.length) unsound()
                repeat(instruction.second) { situation.popValue(ValueType.WHOLE) }
                situation.push(ValueType.reference(named(instruction, type)))
            }

            Opcode.ARRAYLENGTH -> {
                if (relations.typeOrNull(situation.popReference()) is LinkedClass) unsound()
                situation.push(ValueType.WHOLE)
            }

            Opcode.ATHROW -> {
                if (!relations.fits(situation.pop(), types.throwable)) unsound()
            }

            Opcode.CHECKCAST -> {
                situation.popReference()
                situation.push(ValueType.reference(named(instruction, resolver.testedType(operand, place))))
            }

            Opcode.INSTANCEOF -> {
                situation.popReference()
                named(instruction, resolver.testedType(operand, place))
                situation.push(ValueType.WHOLE)
            }

            in Opcode.IRETURN..Opcode.RETURN -> {
                result(instruction.opcode, situation, place)
            }
        }
    }

    private fun constant(instruction: Instruction, situation: Situation, place: Place) {
        val wide = instruction.opcode == Opcode.LDC2_W
        when (val constant = constants.constant(instruction.operand)) {
            is Constant.Whole -> {
                situation.push(ValueType.WHOLE)
            }

            is Constant.Decimal -> {
                situation.push(ValueType.DECIMAL)
            }

            is Constant.Long -> {
                situation.pushValue(ValueType.LONG)
            }

            is Constant.Double -> {
                situation.pushValue(ValueType.DOUBLE)
            }

            is Constant.StringText -> {
                if (constants.string(constant).length > TinyVmLimits.STRING_CHARACTERS) {
                    place.refuse(messages.tooMany(Counted.TEXT_CHARACTERS, TinyVmLimits.STRING_CHARACTERS))
                }
                situation.push(ValueType.reference(types.text))
            }

            is Constant.ClassName -> {
                place.refuse(messages.lacks(LackedFeature.CLASS_LITERAL))
            }

            else -> {
                unsound()
            }
        }
        val isWide = constants.constant(instruction.operand).let { it is Constant.Long || it is Constant.Double }
        if (isWide != wide) unsound()
    }

    private fun element(opcode: Int, situation: Situation) {
        val isStore = opcode >= Opcode.IASTORE
        val letters = ELEMENTS[opcode - if (isStore) Opcode.IASTORE else Opcode.IALOAD]
        val isObject = letters == "L"
        val stored = if (isStore && isObject) situation.popReference() else ValueType.UNUSABLE
        if (isStore && !isObject) situation.popValue(ValueType.ofLetter(letters[0]))
        situation.popValue(ValueType.WHOLE)
        val array = relations.typeOrNull(situation.popReference())
        if (array != null &&
            (array !is ArrayType || (if (isObject) array.element == null else array.elementDescriptor !in letters))
        ) {
            unsound()
        }
        val element = array?.element
        when {
            isStore -> if (isObject && element != null && !relations.fits(stored, element)) unsound()
            isObject -> situation.push(element?.let { ValueType.reference(it) } ?: ValueType.NULL)
            else -> situation.pushValue(ValueType.ofLetter(letters[0]))
        }
    }

    private fun field(instruction: Instruction, situation: Situation, place: Place) {
        val isStatic = instruction.opcode <= Opcode.PUTSTATIC
        val field = code.fields.getOrPut(instruction.place) { resolver.field(instruction.operand, isStatic, place) }
        val isWrite = instruction.opcode == Opcode.PUTSTATIC || instruction.opcode == Opcode.PUTFIELD
        if (isWrite) popOf(field.descriptor, situation, place)
        if (!isStatic && !relations.fits(situation.popReference(), field.owner)) unsound()
        if (!isWrite) pushOf(field.descriptor, situation, place)
    }

    private fun call(instruction: Instruction, situation: Situation, place: Place) {
        val opcode = instruction.opcode
        val called = code.methods.getOrPut(instruction.place) {
            resolver.method(instruction.operand, opcode == Opcode.INVOKESTATIC, place)
        }
        if (called.isConstructor && opcode != Opcode.INVOKESPECIAL) unsound()
        if (opcode == Opcode.INVOKESPECIAL && called.owner.isInterface) unsound()
        for (parameter in called.types.parameters.asReversed()) popOf(parameter, situation, place)
        if (!called.isStatic && !relations.fits(situation.popReference(), called.owner)) unsound()
        if (called.resultWords > 0) pushOf(called.types.result, situation, place)
    }

    private fun result(opcode: Int, situation: Situation, place: Place) {
        val result = method.types.result
        val expected = when {
            result == "V" -> Opcode.RETURN
            isReferenceDescriptor(result) -> Opcode.ARETURN
            else -> Opcode.IRETURN + KINDS.indexOf(RESULT_KINDS[ValueType.ofLetter(result[0])])
        }
        if (opcode != expected) unsound()
        if (opcode != Opcode.RETURN) popOf(result, situation, place)
    }

    private fun popOf(descriptor: String, situation: Situation, place: Place) {
        if (!isReferenceDescriptor(descriptor)) return situation.popValue(ValueType.ofLetter(descriptor[0]))
        if (!relations.fits(situation.popReference(), types.typeOf(descriptor, place))) unsound()
    }

    private fun pushOf(descriptor: String, situation: Situation, place: Place) {
        val isReference = isReferenceDescriptor(descriptor)
        situation.pushValue(if (isReference) ValueType.reference(types.typeOf(descriptor, place)) else ValueType.ofLetter(descriptor[0]))
    }

    private fun named(instruction: Instruction, type: HeapType): HeapType = type.also { code.types[instruction.place] = it }

    private companion object {
        const val ACONST_NULL = 1
        const val BIPUSH = 16
        const val SIPUSH = 17
        const val ABSTRACT = 0x0400

        /** The kinds that loads, stores and returns come in, in the order of their numbers. */
        const val KINDS = "IJFD"

        /** The letters of [ValueType]'s kinds by their numbers. */
        const val RESULT_KINDS = " IFJD"

        /** What elements the array instructions are for, in the order of their numbers. */
        val ELEMENTS = listOf("I", "J", "F", "D", "L", "BZ", "C", "S")
    }
}
