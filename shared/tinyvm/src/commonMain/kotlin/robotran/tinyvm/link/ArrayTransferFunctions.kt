package robotran.tinyvm.link

/** The effects of array instructions on a [FrameState]. */
internal class ArrayTransferFunctions(
    private val relations: TypeRelations,
    private val resolver: Resolver,
    private val code: ResolvedCode,
) {
    /** Applies an instruction that creates an array or reads its length. */
    fun apply(instruction: Instruction, frameState: FrameState, location: CodeLocation) {
        when (instruction.opcode) {
            Opcode.NEWARRAY -> {
                frameState.popValue(VerificationType.INT)
                push(instruction, resolver.numberArray(instruction.operand, location), frameState)
            }

            Opcode.ANEWARRAY -> {
                frameState.popValue(VerificationType.INT)
                push(instruction, resolver.arrayOf(instruction.operand, location), frameState)
            }

            Opcode.MULTIANEWARRAY -> {
                val type = resolver.type(instruction.operand, location)
                if (instruction.second !in 1..type.descriptor.takeWhile { it == '[' }.length) unsound()
                repeat(instruction.second) { frameState.popValue(VerificationType.INT) }
                push(instruction, type, frameState)
            }

            else -> {
                if (relations.typeOrNull(frameState.popReference()) is LinkedClass) unsound()
                frameState.push(VerificationType.INT)
            }
        }
    }

    private fun push(instruction: Instruction, type: HeapType, frameState: FrameState) {
        code.types[instruction.place] = type
        frameState.push(VerificationType.reference(type))
    }

    /** Applies an array load or store. */
    fun element(opcode: Int, frameState: FrameState) {
        val isStore = opcode >= Opcode.IASTORE
        val letters = ELEMENTS[opcode - if (isStore) Opcode.IASTORE else Opcode.IALOAD]
        val isObject = letters == "L"
        if (isStore && isObject) frameState.popReference()
        if (isStore && !isObject) frameState.popValue(VerificationType.ofLetter(letters[0]))
        frameState.popValue(VerificationType.INT)
        val array = relations.typeOrNull(frameState.popReference())
        if (array != null &&
            (array !is ArrayType || (if (isObject) array.element == null else array.elementDescriptor !in letters))
        ) {
            unsound()
        }
        val element = array?.element
        when {
            // A machine looks at what it stores, since an array may be one of a subclass.
            isStore -> return
            isObject -> frameState.push(element?.let { VerificationType.reference(it) } ?: VerificationType.NULL)
            else -> frameState.pushValue(VerificationType.ofLetter(letters[0]))
        }
    }

    private companion object {
        /** The element types of the array instructions, in opcode order. */
        val ELEMENTS = listOf("I", "J", "F", "D", "L", "BZ", "C", "S")
    }
}
