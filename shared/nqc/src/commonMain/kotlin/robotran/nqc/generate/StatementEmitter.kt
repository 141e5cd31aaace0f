package robotran.nqc.generate

import robotran.language.source.SourceFix
import robotran.language.source.SourceRange
import robotran.legofirmware.image.FirmwareTarget
import robotran.legofirmware.instructions.Opcode
import robotran.legofirmware.instructions.ValueSource
import robotran.nqc.diagnostic.NqcDiagnosticCode
import robotran.nqc.syntax.onlySimilarName
import robotran.nqc.syntax.similarName
import robotran.nqc.tree.Expression
import robotran.nqc.tree.Expression.Cell
import robotran.nqc.tree.LeaveKind
import robotran.nqc.tree.Place
import robotran.nqc.tree.Statement
import robotran.nqc.tree.Variable

/** Generates the code of statements. */
internal class StatementEmitter(
    private val emitter: Emitter,
    private val units: ProgramUnits,
    private val names: VariableNames,
) {
    private val sink = emitter.sink
    private val buffer = emitter.buffer
    val values = ValueEmitter(emitter)
    val flow = FlowContext(emitter)
    private val branches = BranchEmitter(emitter, this)
    private val loops = LoopEmitter(emitter, this)
    private val guards = GuardEmitter(emitter, this)
    private val assembly = AssemblyEmitter(emitter, values)
    private val calls = CallEmitter(emitter, this, units)

    /** The variables to release at the end of each open block. */
    private val scopes = mutableListOf<MutableList<Int>>(mutableListOf())

    fun emit(statement: Statement, frame: FrameLayout) {
        emitter.work(1)
        if (statement !is Statement.Block) mark(statement, frame)
        when (statement) {
            is Statement.Block -> block(statement, frame)
            is Statement.Declaration -> declaration(statement, frame)
            is Statement.Assignment -> assignment(statement, frame)
            is Statement.Update -> update(statement, frame)
            is Statement.Evaluation -> values.sideEffects(value(statement.value, frame))
            is Statement.Call -> calls.call(statement, frame)
            is Statement.If -> branches.branch(statement, frame)
            is Statement.Switch -> branches.switch(statement, frame)
            is Statement.Case -> branches.case(statement, frame)
            is Statement.While -> loops.whileLoop(statement, frame)
            is Statement.DoWhile -> loops.doWhile(statement, frame)
            is Statement.For -> loops.forLoop(statement, frame)
            is Statement.Repeat -> loops.repeat(statement, frame)
            is Statement.Label -> label(statement, frame)
            is Statement.Goto -> goto(statement, frame)
            is Statement.Leave -> leave(statement)
            is Statement.TaskCommand -> taskCommand(statement)
            is Statement.Monitor -> guards.monitor(statement, frame)
            is Statement.Acquire -> guards.acquire(statement, frame)
            is Statement.Assembly -> assembly.emit(statement, frame)
        }
    }

    /** Says that what follows comes from [statement]. */
    fun mark(statement: Statement, frame: FrameLayout) {
        emitter.position = frame.call ?: statement.range
        if (emitter.position.line > 0) buffer.mark(emitter.position)
    }

    fun value(expression: Expression, frame: FrameLayout): Expression = Instantiation(emitter, frame).of(expression)

    private fun block(statement: Statement.Block, frame: FrameLayout) {
        if (statement.isScope) {
            inScope { statement.statements.forEach { emit(it, frame) } }
        } else {
            statement.statements.forEach { emit(it, frame) }
        }
    }

    /** Generates [body] and releases the variables that it declares. */
    fun inScope(body: () -> Unit) {
        val places = mutableListOf<Int>()
        scopes += places
        body()
        places.asReversed().forEach { emitter.allocator.release(it) }
        scopes.removeAt(scopes.lastIndex)
    }

    private fun declaration(statement: Statement.Declaration, frame: FrameLayout) {
        val variable = statement.variable
        if (!variable.isGlobal) {
            val place = allocate(variable.size, statement.range)
            frame.bind(variable, Cell(place, variable.isPointer, variable.range))
            name(variable, place)
        }
        statement.initial?.let { emit(it, frame) }
    }

    /** Allocates variables until the end of the block. */
    fun allocate(size: Int, range: SourceRange): Int {
        val place = emitter.allocator.allocate(size, isTemporary = false)
        if (place == null) {
            emitter.outOfVariables()
            val isShared = emitter.allocator.mode == AllocationMode.SUB_OF_MANY_TASKS
            val message = if (isShared) sink.messages.noStorageInSharedSub() else sink.messages.noStorage()
            emitter.report(NqcDiagnosticCode.NO_STORAGE, range, message)
            throw GenerationStop()
        }
        scopes.last() += place until place + size
        return place
    }

    /** Gives the variable or parameter [variable] its name in the image. */
    fun name(variable: Variable, index: Int) = names.add(variable, index)

    private fun assignment(statement: Statement.Assignment, frame: FrameLayout) =
        assign(value(statement.target, frame), value(statement.value, frame))

    fun assign(target: Expression, value: Expression) {
        val place = if (target.constant == null) values.any(target) else Emitter.constant(0)
        when {
            place.isVariable -> values.to(value, place.data)

            isWritable(place) -> {
                val source = values.any(value)
                emitter.set(place, source)
                emitter.release(source)
            }

            else -> emitter.report(NqcDiagnosticCode.NOT_ASSIGNABLE, target.range, sink.messages.notAssignable())
        }
        emitter.release(place)
    }

    private fun isWritable(place: Place) =
        emitter.target == FirmwareTarget.RCX2 && ValueSource.of(place.type)?.isWritable == true

    private fun update(statement: Statement.Update, frame: FrameLayout) {
        val target = value(statement.target, frame)
        if (target !is Cell) {
            emitter.report(NqcDiagnosticCode.NOT_ASSIGNABLE, target.range, sink.messages.notAssignable())
            return
        }
        val place = values.operand(value(statement.value, frame))
        emitter.operation(statement.operation, target.place, place)
        emitter.release(place)
    }

    private fun label(statement: Statement.Label, frame: FrameLayout) {
        frame.labels[statement.name]?.let { buffer.place(it) }
        emit(statement.body, frame)
    }

    private fun goto(statement: Statement.Goto, frame: FrameLayout) {
        val label = frame.labels[statement.label]
        if (label == null) {
            val message = sink.messages.undefinedLabel(statement.label)
            return emitter.report(NqcDiagnosticCode.UNDEFINED_LABEL, statement.range, message)
        }
        emitter.jump(label)
    }

    private fun leave(statement: Statement.Leave) {
        if (flow.leave(statement.kind)) return
        if (statement.kind == LeaveKind.CONTINUE) {
            val message = sink.messages.continueOutsideLoop()
            emitter.report(NqcDiagnosticCode.CONTINUE_OUTSIDE_LOOP, statement.range, message)
        } else {
            emitter.report(NqcDiagnosticCode.BREAK_OUTSIDE_LOOP, statement.range, sink.messages.breakOutsideLoop())
        }
    }

    private fun taskCommand(statement: Statement.TaskCommand) {
        val number = units.tasks[statement.task]
        if (number == null) {
            val similar = similarName(statement.task, units.tasks.keys)
            val message = sink.messages.undefinedTask(statement.task, similar)
            val only = onlySimilarName(statement.task, units.tasks.keys).takeIf { statement.name.macro == null }
            val fix = only?.let { SourceFix(statement.name.range, it) }
            return sink.report(NqcDiagnosticCode.UNDEFINED_TASK, statement.range, message, fix)
        }
        emitter.add(if (statement.isStart) Opcode.START else Opcode.STOP, number)
    }

    /** Makes the labels of a [body] that begins here; reports a name that is there twice. */
    fun labelsOf(body: Statement): Map<String, Label> {
        val labels = HashMap<String, Label>()
        for (label in units.jumpsOf(body).labels) {
            if (label.name in labels) {
                val message = sink.messages.labelRedefined(label.name)
                emitter.report(NqcDiagnosticCode.LABEL_REDEFINED, label.range, message)
            } else {
                labels[label.name] = buffer.label()
            }
        }
        return labels
    }
}
