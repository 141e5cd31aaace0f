package robotran.nqc.generate

import robotran.language.source.SourceRange
import robotran.legofirmware.image.FirmwareTarget
import robotran.legofirmware.instructions.Opcode
import robotran.legofirmware.instructions.Relation
import robotran.legofirmware.instructions.ValueSource
import robotran.nqc.config.NqcLimits
import robotran.nqc.diagnostic.API_RANGE
import robotran.nqc.diagnostic.DiagnosticSink
import robotran.nqc.diagnostic.NqcDiagnosticCode
import robotran.nqc.tree.Place
import robotran.nqc.tree.VariableOperation

/** Adds instructions to the code of one task or subroutine and takes temporary variables for them. */
internal class Emitter(
    val target: FirmwareTarget,
    val allocator: PlaceAllocator,
    val sink: DiagnosticSink,
    private val budget: GenerationBudget,
    val sensors: SensorUse,
) {
    val buffer = CodeBuffer()

    /** The statement that code is generated for. */
    var position = API_RANGE

    /** Whether a variable with the number of another one is released where the original compiler forgets to. */
    val releasesAll: Boolean get() = budget.releasesAll

    /** Adds an instruction. */
    fun add(opcode: Opcode, vararg operands: Int) = addBytes(opcode.code, *operands)

    fun addBytes(vararg bytes: Int) {
        buffer.add(*bytes)
        checkSize()
    }

    fun jump(label: Label) = jump(Opcode.JMPL, label)

    /** @param opcode the long form. */
    fun jump(opcode: Opcode, label: Label, vararg operands: Int) {
        buffer.addJump(opcode, label, *operands)
        checkSize()
    }

    /** Continues at [label] if [left] [relation] [right]. */
    fun test(left: Place, relation: Relation, right: Place, label: Label) {
        val first = relation.code shl RELATION_SHIFT or left.type
        jump(Opcode.CHKL, label, first, right.type, low(left.data), high(left.data), low(right.data))
    }

    /** Changes the variable [variable] by [value]. */
    fun operation(operation: VariableOperation, variable: Int, value: Place) =
        add(OPCODES.getValue(operation), variable, value.type, low(value.data), high(value.data))

    /** Assigns [value] to the variable [variable], unless it is that variable. */
    fun move(variable: Int, value: Place) {
        if (value.isVariable && value.data == variable) return
        operation(VariableOperation.SET, variable, value)
    }

    /** Assigns [value] to [place], which is no variable. */
    fun set(place: Place, value: Place) {
        sensors.noteTarget(place)
        add(Opcode.SET, place.type, low(place.data), value.type, low(value.data), high(value.data))
    }

    /** Takes a temporary variable. */
    fun temporary(range: SourceRange, allowsLocals: Boolean = true): Int =
        allocator.allocate(1, isTemporary = true, allowsLocals) ?: run {
            budget.isOutOfVariables = true
            val isShared = allocator.mode == AllocationMode.SUB_OF_MANY_TASKS
            val message = if (isShared) sink.messages.noStorageInSharedSub() else sink.messages.noTemporaries()
            sink.report(NqcDiagnosticCode.NO_TEMPORARIES, place(range), message)
            throw GenerationStop()
        }

    /** Gives back the temporary variable that [place] is or uses; nothing if there is none. */
    fun release(place: Place) {
        if ((place.isVariable || place.usesTemporary) && allocator.isTemporary(place.data)) {
            allocator.release(place.data)
        }
    }

    fun isTemporary(place: Place): Boolean = place.isVariable && allocator.isTemporary(place.data)

    fun report(code: NqcDiagnosticCode, range: SourceRange, message: String) = sink.report(code, place(range), message)

    /** The [range], or that of the statement for something in the API. */
    fun place(range: SourceRange): SourceRange = if (range.line > 0) range else position

    fun outOfVariables() {
        budget.isOutOfVariables = true
    }

    /** Counts work, so that no program takes too long. */
    fun work(steps: Int) {
        budget.steps += steps
        if (budget.steps > NqcLimits.GENERATOR_STEPS) tooLong()
    }

    private fun checkSize() {
        if (buffer.size > NqcLimits.CODE_BYTES) tooLong()
    }

    fun tooLong(): Nothing {
        sink.report(NqcDiagnosticCode.PROGRAM_TOO_LONG, position, sink.messages.codeTooLong(NqcLimits.CODE_BYTES))
        throw GenerationStop()
    }

    companion object {
        private const val RELATION_SHIFT = 6
        private const val BYTE = 0xFF

        fun low(number: Int): Int = number and BYTE

        fun high(number: Int): Int = number shr Byte.SIZE_BITS and BYTE

        fun constant(value: Int) = Place(ValueSource.CONSTANT, value)

        fun variable(number: Int) = Place(ValueSource.VARIABLE, number)

        private val OPCODES = mapOf(
            VariableOperation.SET to Opcode.SETV,
            VariableOperation.ADD to Opcode.SUMV,
            VariableOperation.SUBTRACT to Opcode.SUBV,
            VariableOperation.DIVIDE to Opcode.DIVV,
            VariableOperation.MULTIPLY to Opcode.MULV,
            VariableOperation.SIGN to Opcode.SGNV,
            VariableOperation.ABSOLUTE to Opcode.ABSV,
            VariableOperation.AND to Opcode.ANDV,
            VariableOperation.OR to Opcode.ORV,
        )
    }
}
