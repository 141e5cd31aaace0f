package robotran.tinyvm.link

/** What instructions do to a [FrameState] that make arrays or reach into them. */
internal class ArrayEffects(private val relations: TypeRelations, private val resolver: Resolver, private val code: ResolvedCode) {
    /** Makes an array or asks for its length. */
    fun apply(instruction: Instruction, situation: FrameState, place: Place) {
        when (instruction.opcode) {
            Opcode.NEWARRAY -> {
                situation.popValue(ValueType.WHOLE)
                push(instruction, resolver.numberArray(instruction.operand, place), situation)
            }

            Opcode.ANEWARRAY -> {
                situation.popValue(ValueType.WHOLE)
                push(instruction, resolver.arrayOf(instruction.operand, place), situation)
            }

            Opcode.MULTIANEWARRAY -> {
                val type = resolver.type(instruction.operand, place)
                if (instruction.second !in 1..type.descriptor.takeWhile { it == '[' }.length) unsound()
                repeat(instruction.second) { situation.popValue(ValueType.WHOLE) }
                push(instruction, type, situation)
            }

            else -> {
                if (relations.typeOrNull(situation.popReference()) is LinkedClass) unsound()
                situation.push(ValueType.WHOLE)
            }
        }
    }

    private fun push(instruction: Instruction, type: HeapType, situation: FrameState) {
        code.types[instruction.place] = type
        situation.push(ValueType.reference(type))
    }

    /** Reads or writes an element. */
    fun element(opcode: Int, situation: FrameState) {
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

    private companion object {
        /** What elements the array instructions are for, in the order of their numbers. */
        val ELEMENTS = listOf("I", "J", "F", "D", "L", "BZ", "C", "S")
    }
}
