package robotran.tinyvm.link

/** The effects on a [FrameState] of instructions that access fields, call methods or return. */
internal class MemberTransferFunctions(
    private val method: LinkedMethod,
    private val types: TypeTable,
    private val relations: TypeRelations,
    private val resolver: Resolver,
    private val code: ResolvedCode,
) {
    fun field(instruction: Instruction, frameState: FrameState, location: CodeLocation) {
        val isStatic = instruction.opcode <= Opcode.PUTSTATIC
        val field = code.fields.getOrPut(instruction.place) { resolver.field(instruction.operand, isStatic, location) }
        val isWrite = instruction.opcode == Opcode.PUTSTATIC || instruction.opcode == Opcode.PUTFIELD
        if (isWrite) popOf(field.descriptor, frameState, location)
        if (!isStatic && !relations.fits(frameState.popReference(), field.owner)) unsound()
        if (!isWrite) field.isRead = true
        if (!isWrite) pushOf(field.descriptor, frameState, location)
    }

    fun call(instruction: Instruction, frameState: FrameState, location: CodeLocation) {
        val opcode = instruction.opcode
        val called = code.methods.getOrPut(instruction.place) {
            resolver.method(instruction.operand, opcode == Opcode.INVOKESTATIC, location)
        }
        if (called.isConstructor && opcode != Opcode.INVOKESPECIAL) unsound()
        if (opcode == Opcode.INVOKESPECIAL && called.owner.isInterface) unsound()
        for (parameter in called.types.parameters.asReversed()) popOf(parameter, frameState, location)
        if (!called.isStatic && !relations.fits(frameState.popReference(), called.owner)) unsound()
        if (called.resultWords > 0) pushOf(called.types.result, frameState, location)
    }

    fun result(opcode: Int, frameState: FrameState, location: CodeLocation) {
        val result = method.types.result
        val expected = when {
            result == "V" -> Opcode.RETURN
            isReferenceDescriptor(result) -> Opcode.ARETURN
            else -> Opcode.IRETURN + KINDS.indexOf(RESULT_KINDS[VerificationType.ofLetter(result[0])])
        }
        if (opcode != expected) unsound()
        if (opcode != Opcode.RETURN) popOf(result, frameState, location)
    }

    private fun popOf(descriptor: String, frameState: FrameState, location: CodeLocation) {
        if (!isReferenceDescriptor(descriptor)) return frameState.popValue(VerificationType.ofLetter(descriptor[0]))
        if (!relations.fits(frameState.popReference(), types.typeOf(descriptor, location))) unsound()
    }

    private fun pushOf(descriptor: String, frameState: FrameState, location: CodeLocation) {
        val isReference = isReferenceDescriptor(descriptor)
        frameState.pushValue(
            if (isReference) {
                VerificationType.reference(types.typeOf(descriptor, location))
            } else {
                VerificationType.ofLetter(descriptor[0])
            },
        )
    }

    private companion object {
        /** The result types of the return instructions, in opcode order. */
        const val KINDS = "IJFD"

        /** The letters of the [VerificationType] kinds, by number. */
        const val RESULT_KINDS = " IFJD"
    }
}
