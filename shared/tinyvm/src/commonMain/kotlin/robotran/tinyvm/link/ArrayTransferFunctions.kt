package robotran.tinyvm.link

/** The effects of array instructions on a [FrameState]. */
internal class ArrayTransferFunctions(
    private val relations: TypeRelations,
    private val resolver: Resolver,
    private val code: ResolvedCode,
) {
    /** Applies an instruction that creates an array or reads its length. */
    fun apply(instruction: Instruction, situation: FrameState, place: CodeLocation) {
        when (instruction.opcode) {
            Opcode.NEWARRAY -> {
                situation.popValue(VerificationType.WHOLE)
                push(instruction, resolver.numberArray(instruction.operand, place), situation)
            }

            Opcode.ANEWARRAY -> {
                situation.popValue(VerificationType.WHOLE)
                push(instruction, resolver.arrayOf(instruction.operand, place), situation)
            }

            Opcode.MULTIANEWARRAY -> {
                val type = resolver.type(instruction.operand, place)
                if (instruction.second !in 1..type.descriptor.takeWhile { it == '[' }.length) unsound()
                repeat(instruction.second) { situation.popValue(VerificationType.WHOLE) }
                push(instruction, type, situation)
            }

            else -> {
                if (relations.typeOrNull(situation.popReference()) is LinkedClass) unsound()
                situation.push(VerificationType.WHOLE)
            }
        }
    }

    private fun push(instruction: Instruction, type: HeapType, situation: FrameState) {
        code.types[instruction.place] = type
        situation.push(VerificationType.reference(type))
    }

    /** Applies an array load or store. */
    fun element(opcode: Int, situation: FrameState) {
        val isStore = opcode >= Opcode.IASTORE
        val letters = ELEMENTS[opcode - if (isStore) Opcode.IASTORE else Opcode.IALOAD]
        val isObject = letters == "L"
        val stored = if (isStore && isObject) situation.popReference() else VerificationType.UNUSABLE
        if (isStore && !isObject) situation.popValue(VerificationType.ofLetter(letters[0]))
        situation.popValue(VerificationType.WHOLE)
        val array = relations.typeOrNull(situation.popReference())
        if (array != null &&
            (array !is ArrayType || (if (isObject) array.element == null else array.elementDescriptor !in letters))
        ) {
            unsound()
        }
        val element = array?.element
        when {
            isStore -> if (isObject && element != null && !relations.fits(stored, element)) unsound()
            isObject -> situation.push(element?.let { VerificationType.reference(it) } ?: VerificationType.NULL)
            else -> situation.pushValue(VerificationType.ofLetter(letters[0]))
        }
    }

    private companion object {
        /** The element types of the array instructions, in opcode order. */
        val ELEMENTS = listOf("I", "J", "F", "D", "L", "BZ", "C", "S")
    }
}
