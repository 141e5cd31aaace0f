package robotran.nqc.generate

import robotran.language.source.SourceRange
import robotran.legofirmware.image.Chunk
import robotran.legofirmware.image.ChunkId
import robotran.legofirmware.image.ChunkKind
import robotran.legofirmware.image.CodeBytes
import robotran.legofirmware.image.FirmwareTarget
import robotran.legofirmware.image.RcxImage
import robotran.legofirmware.image.Symbol
import robotran.legofirmware.image.SymbolKind
import robotran.nqc.config.NqcLimits
import robotran.nqc.diagnostic.DiagnosticSink
import robotran.nqc.diagnostic.NqcDiagnosticCode
import robotran.nqc.tree.Expression
import robotran.nqc.tree.Expression.Cell
import robotran.nqc.tree.ParsedProgram
import robotran.nqc.tree.Statement
import robotran.nqc.tree.Variable

/**
 * Generates the image of a program whose names and calls are right.
 *
 * @param start what comes before the main task's own commands, after the initial values.
 * @param reserved variables that must not be used, each with the place that asks for it.
 * @param subsOfTasks the subroutines that each task calls.
 */
internal class ProgramGenerator(
    private val program: ParsedProgram,
    private val start: Statement?,
    private val reserved: List<Pair<IntRange, SourceRange>>,
    private val subsOfTasks: Map<String, Set<String>>,
    private val target: FirmwareTarget,
    private val sink: DiagnosticSink,
    releasesAll: Boolean,
) {
    private val budget = GenerationBudget(releasesAll)
    private val allocator = PlaceAllocator(target)
    private val names = VariableNames()
    private val sensors = SensorUse()
    private val globals = HashMap<Variable, Expression>()

    // The main task is number 0, the others count in the order of the source.
    private val tasks = program.tasks.sortedBy { it.name != MAIN }
    private val taskNumbers = tasks.mapIndexed { number, task -> task.name to number }.toMap()
    private val subs = program.subs.mapIndexed { number, sub -> sub.name to SubCode(number) }.toMap()
    private val units = ProgramUnits(taskNumbers, subs, program.functions)
    private val chunks = mutableListOf<Chunk>()
    private val symbols = mutableListOf<Symbol>()
    private val lines = HashMap<ChunkId, List<NqcCodeLine>>()

    fun generate(): GeneratedProgram {
        reserve()
        if (allocateGlobals()) {
            for ((task, subsOfTask) in subsOfTasks) {
                subsOfTask.forEach { subs.getValue(it).tasks += taskNumbers.getValue(task) }
            }
            program.subs.forEach { sub -> generateSub(sub.name, sub.body) }
            tasks.forEachIndexed { number, task -> generateTask(number, task.name, task.body) }
        }
        names.all.forEach { symbols += Symbol(SymbolKind.VARIABLE, it.place, nameOf(it.variable.name)) }
        return GeneratedProgram(
            RcxImage(target, chunks, symbols),
            lines,
            names.table,
            sensors.unset,
            budget.isOutOfVariables,
        )
    }

    private fun reserve() {
        for ((places, range) in reserved) {
            if (!allocator.reserve(places)) {
                sink.report(NqcDiagnosticCode.NOT_RESERVED, range, sink.messages.notReserved(lastVariable()))
            }
        }
    }

    private fun lastVariable() = if (target == FirmwareTarget.RCX2) LAST_LOCAL else LAST_GLOBAL

    /** Gives the global variables their places; false if there are too many. */
    private fun allocateGlobals(): Boolean {
        for (declaration in program.globals) {
            val variable = declaration.variable
            val place = allocator.allocate(variable.size, isTemporary = false)
            if (place == null) {
                budget.isOutOfVariables = true
                sink.report(NqcDiagnosticCode.NO_STORAGE, declaration.range, sink.messages.noStorage())
                return false
            }
            globals[variable] = Cell(place, variable.isPointer, variable.range)
            names.add(variable, place)
        }
        return true
    }

    private fun generateSub(name: String, body: Statement) {
        val sub = subs.getValue(name)
        val mode = if (sub.tasks.size > 1) AllocationMode.SUB_OF_MANY_TASKS else AllocationMode.SUB_OF_ONE_TASK
        val task = if (sub.tasks.size > 1) null else sub.tasks.singleOrNull() ?: 0
        sub.locals = generateChunk(ChunkId(ChunkKind.SUB, sub.number), name, mode, task, listOf(body))
    }

    private fun generateTask(number: Int, name: String, body: Statement) {
        val before = if (name == MAIN) program.globals + listOfNotNull(start) else emptyList()
        generateChunk(ChunkId(ChunkKind.TASK, number), name, AllocationMode.TASK, number, before + body)
    }

    /** Generates the code of a task or subroutine and returns the local variables that it uses. */
    private fun generateChunk(
        id: ChunkId,
        name: String,
        mode: AllocationMode,
        task: Int?,
        bodies: List<Statement>,
    ): Set<Int> {
        allocator.begin(mode)
        names.owner = id
        val emitter = Emitter(target, allocator, sink, budget, sensors)
        val statements = StatementEmitter(emitter, units, names)
        var code = Code(ByteArray(0), emptyList())
        try {
            val body = Statement.Block(bodies, isScope = false, bodies.last().range)
            val frame = FrameLayout(globals, null, task, 0, statements.labelsOf(body), units.jumpsOf(body).targets)
            statements.flow.withinFunction { statements.emit(body, frame) }
            code = emitter.buffer.layout()
        } catch (_: GenerationStop) {
            // The reason is reported, so that nobody gets the image.
        }
        chunks += Chunk(id, CodeBytes(code.bytes))
        symbols += Symbol(if (id.kind == ChunkKind.TASK) SymbolKind.TASK else SymbolKind.SUB, id.number, nameOf(name))
        lines[id] = code.lines
        return allocator.end()
    }

    private fun nameOf(name: String) = name.take(NqcLimits.NAME_CHARACTERS)

    companion object {
        const val MAIN = "main"

        private const val LAST_GLOBAL = 31
        private const val LAST_LOCAL = 47
    }
}
