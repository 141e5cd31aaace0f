package robotran.tinyvm.link

import robotran.tinyvm.classfile.CodeEntry
import robotran.tinyvm.classfile.Constant

/** Translates verified code into operations. Unreachable code is left out. */
internal class Translator(
    private val method: LinkedMethod,
    private val entry: CodeEntry,
    private val code: ResolvedCode,
    private val types: TypeTable,
    private val texts: StringPool,
) {
    private val constants = method.owner.file.constants
    private val writer = CodeWriter()
    private val isExact = types.model.isExact
    private val simpleInstructions = simpleInstructions(isExact)
    private val members = MemberTranslator(method, code, types, writer)

    fun translate(): MethodBody {
        val positions = IntArray(entry.bytes.size + 1)
        val lineStarts = if (method.owner.isOfProgram) entry.lines.lineStarts else emptySet()
        for (place in entry.bytes.indices) {
            positions[place] = writer.size
            val instruction = code.reached[place] ?: continue
            writer.place = place
            if (place in lineStarts && code.depths[place] == 0 && !leadsToItsLine(instruction, lineStarts)) {
                writer.write(Operation.STATEMENT, entry.lines.lineAt(place))
            }
            translate(instruction)
        }
        positions[entry.bytes.size] = writer.size
        val words = writer.finish(positions)
        val places = writer.finishedPositions()
        return MethodBody(words, handlers(positions), places, entry.lines, entry.variables, writer.switches)
    }

    /**
     * Whether [instruction] only jumps to where its line begins once more, as that of a `while` does to its condition.
     * It is no statement of its own: a step from it would stay in the line.
     */
    private fun leadsToItsLine(instruction: Instruction, lineStarts: Set<Int>): Boolean {
        val target = instruction.operand
        return instruction.opcode == Opcode.GOTO && target > instruction.place && target in lineStarts &&
            entry.lines.lineAt(target) == entry.lines.lineAt(instruction.place)
    }

    private fun handlers(positions: IntArray): IntArray = entry.handlers
        .filter { it.target in code.reached.indices && code.reached[it.target] != null && it.start < it.end }
        .flatMap { handler ->
            val type =
                handler.catchType?.let { types.classNamed(it, CodeLocation(method.owner.name, method.name)).id }
                    ?: CATCHES_ALL
            val end = minOf(handler.end, entry.bytes.size)
            val early = code.earlyHandlers[handler] ?: 0
            listOf(positions[handler.start], positions[end], positions[handler.target], type, early)
        }.toIntArray()

    private fun translate(instruction: Instruction) {
        val opcode = instruction.opcode
        val simple = simpleInstructions[opcode]
        val table = instruction.targets
        when {
            simple?.operation == Operation.PUSH_LONG -> pushLong(simple.constant ?: 0, simple.high)

            table != null -> writer.writeSwitch(
                SwitchTable(instruction.keys ?: IntArray(0), table + instruction.operand),
            )

            simple?.constant != null -> writer.write(simple.operation, simple.constant)
            simple != null -> writer.write(simple.operation)
            opcode in BRANCHES -> writer.writeBranch(OperationTables.branch(opcode), instruction.operand)
            opcode in Opcode.GETSTATIC..Opcode.PUTFIELD -> members.field(instruction)
            opcode in Opcode.INVOKEVIRTUAL..Opcode.INVOKEINTERFACE -> members.call(instruction)
            opcode in WITH_TYPE -> members.typed(instruction)
            else -> other(instruction)
        }
    }

    private fun other(instruction: Instruction) {
        val opcode = instruction.opcode
        when (opcode) {
            Opcode.ACONST_NULL -> writer.write(Operation.PUSH, 0)
            Opcode.BIPUSH, Opcode.SIPUSH -> writer.write(Operation.PUSH, instruction.operand)
            Opcode.LDC, Opcode.LDC2_W -> constant(constants.constant(instruction.operand), instruction)
            in Opcode.ILOAD..Opcode.ALOAD -> writer.write(OperationTables.load(opcode, isExact), instruction.operand)
            in Opcode.ISTORE..Opcode.ASTORE -> writer.write(OperationTables.store(opcode, isExact), instruction.operand)
            in Opcode.IALOAD..Opcode.SALOAD -> writer.write(OperationTables.arrayLoad(opcode, isExact))
            in Opcode.IASTORE..Opcode.SASTORE -> writer.write(OperationTables.arrayStore(opcode, isExact))
            in Opcode.POP..Opcode.SWAP -> writer.write(Operation.POP + opcode - Opcode.POP)
            Opcode.IINC -> writer.write(Operation.INCREMENT, instruction.operand, instruction.second)
            Opcode.RET -> writer.write(Operation.END_SUBROUTINE, instruction.operand)
            Opcode.RETURN -> writer.write(Operation.RETURN)

            in Opcode.IRETURN..Opcode.ARETURN -> {
                writer.write(if (method.resultWords == 2) Operation.RETURN_WIDE else Operation.RETURN_VALUE)
            }

            Opcode.ARRAYLENGTH -> writer.write(Operation.LENGTH)
            Opcode.ATHROW -> writer.write(Operation.THROW)
            Opcode.MONITORENTER -> writer.write(Operation.ENTER_MONITOR)
            Opcode.MONITOREXIT -> writer.write(Operation.EXIT_MONITOR)
            else -> error("no operation for bytecode $opcode")
        }
    }

    private fun pushLong(low: Int, high: Int) {
        writer.write(Operation.PUSH_LONG, low, high)
    }

    private fun pushWide(value: Long, wordOnRcx: Int) {
        if (isExact) {
            pushLong(value.toInt(), (value shr Int.SIZE_BITS).toInt())
        } else {
            writer.write(Operation.PUSH_WIDE, wordOnRcx)
        }
    }

    private fun constant(constant: Constant, instruction: Instruction) = when (constant) {
        is Constant.Whole -> writer.write(Operation.PUSH, constant.value)
        is Constant.Decimal -> writer.write(Operation.PUSH, constant.value.toBits())
        is Constant.Long -> pushWide(constant.value, constant.value.toInt())
        is Constant.Double -> pushWide(constant.value.toBits(), constant.value.toFloat().toBits())
        is Constant.StringText -> writer.write(Operation.PUSH_TEXT, texts.numberOf(constants.string(constant)))
        is Constant.ClassName -> writer.write(Operation.PUSH_CLASS, code.types.getValue(instruction.place).id)
        else -> error("no constant that can be pushed")
    }

    companion object {
        /** The type id of a handler that catches everything. */
        const val CATCHES_ALL = -1

        /** The numbers of a handler, see [MethodBody.handlers]. */
        const val HANDLER_NUMBERS = 5

        private val BRANCHES = (Opcode.IFEQ..Opcode.JSR).toSet() + Opcode.IFNULL + Opcode.IFNONNULL

        private val WITH_TYPE = setOf(
            Opcode.NEW,
            Opcode.NEWARRAY,
            Opcode.ANEWARRAY,
            Opcode.MULTIANEWARRAY,
            Opcode.CHECKCAST,
            Opcode.INSTANCEOF,
        )
    }
}
