package robotran.tinyvm.link

/** Translates bytecodes that name a field, a method or a type. */
internal class MemberTranslator(
    private val method: LinkedMethod,
    private val code: ResolvedCode,
    private val types: TypeTable,
    private val writer: CodeWriter,
) {
    fun field(instruction: Instruction) {
        val field = code.fields.getValue(instruction.place)
        if (field.isStatic) initialize(field.owner)
        // What an exact machine stores was made a character before.
        val isCharacter = field.descriptor == "C" && !types.model.isExact
        val plain = when (instruction.opcode) {
            Opcode.GETSTATIC -> Operation.STATIC
            Opcode.PUTSTATIC -> if (isCharacter) Operation.SET_STATIC_CHARACTER else Operation.SET_STATIC
            Opcode.GETFIELD -> Operation.FIELD
            else -> if (isCharacter) Operation.SET_FIELD_CHARACTER else Operation.SET_FIELD
        }
        val operation = when {
            !field.isWide -> plain
            types.model.isExact -> LONG_FORMS.getValue(plain)
            else -> plain + 1
        }
        writer.write(operation, field.slot)
    }

    fun call(instruction: Instruction) {
        val called = code.methods.getValue(instruction.place)
        when {
            instruction.opcode == Opcode.INVOKESTATIC -> {
                initialize(called.owner)
                writer.write(Operation.CALL_STATIC, called.number)
            }

            instruction.opcode == Opcode.INVOKESPECIAL -> {
                initialize(called.owner)
                writer.write(Operation.CALL_EXACTLY, called.number)
            }

            called.owner.isInterface -> {
                writer.write(
                    Operation.CALL_INTERFACE,
                    types.members.interfaceNumber(called.signature),
                    called.argumentWords,
                )
            }

            else -> writer.write(Operation.CALL_VIRTUAL, called.virtualIndex, called.argumentWords)
        }
    }

    fun typed(instruction: Instruction) {
        val type = code.types.getValue(instruction.place)
        when (instruction.opcode) {
            Opcode.NEW -> {
                initialize(type as LinkedClass)
                writer.write(Operation.NEW, type.id)
            }

            Opcode.MULTIANEWARRAY -> writer.write(Operation.NEW_ARRAYS, type.id, instruction.second)
            Opcode.CHECKCAST -> writer.write(Operation.CAST, type.id)
            Opcode.INSTANCEOF -> writer.write(Operation.IS_INSTANCE, type.id)
            else -> writer.write(Operation.NEW_ARRAY, type.id)
        }
    }

    /**
     * Ensures that [used] is initialized. The method's own class already is, but on a brick its superclasses may not be.
     */
    private fun initialize(used: LinkedClass) {
        if (used.needsInitializing && used !== method.owner) writer.write(Operation.INITIALIZE, used.number)
    }

    private companion object {
        val LONG_FORMS = mapOf(
            Operation.STATIC to Operation.STATIC_LONG,
            Operation.SET_STATIC to Operation.SET_STATIC_LONG,
            Operation.FIELD to Operation.FIELD_LONG,
            Operation.SET_FIELD to Operation.SET_FIELD_LONG,
        )
    }
}
