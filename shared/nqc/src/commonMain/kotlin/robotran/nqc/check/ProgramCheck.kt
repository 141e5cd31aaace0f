package robotran.nqc.check

import robotran.language.source.SourceFix
import robotran.language.source.SourceRange
import robotran.legofirmware.image.FirmwareLimits
import robotran.nqc.diagnostic.DiagnosticSink
import robotran.nqc.diagnostic.NqcDiagnosticCode
import robotran.nqc.parse.DeclaredUnits
import robotran.nqc.preprocess.InitFunction
import robotran.nqc.syntax.similarName
import robotran.nqc.tree.ParsedProgram
import robotran.nqc.tree.Statement

/**
 * Checks what a program must have, and what it has too much of.
 *
 * @param declared what it declares, also what could not be read.
 */
internal class ProgramCheck(
    private val program: ParsedProgram,
    private val declared: DeclaredUnits,
    private val sink: DiagnosticSink,
) {
    /** @param end where the program's main file ends. */
    fun check(end: SourceRange, init: InitFunction?) {
        if (program.tasks.none { it.name == MAIN } && !declared.isTask(MAIN)) reportMissingMain(end)
        if (init != null && init.name !in program.functions && !declared.isFunction(init.name)) {
            sink.report(NqcDiagnosticCode.INIT_UNDEFINED, init.range, sink.messages.initUndefined(init.name))
        }
        warnOfTasksThatNeverStart()
        program.tasks.getOrNull(FirmwareLimits.TASKS)?.let {
            val message = sink.messages.tooManyTasks(FirmwareLimits.TASKS)
            sink.report(NqcDiagnosticCode.TOO_MANY_TASKS, it.range, message)
        }
        program.subs.getOrNull(FirmwareLimits.SUBROUTINES)?.let {
            val message = sink.messages.tooManySubs(FirmwareLimits.SUBROUTINES)
            sink.report(NqcDiagnosticCode.TOO_MANY_SUBS, it.range, message)
        }
    }

    private fun warnOfTasksThatNeverStart() {
        val bodies = program.tasks.map { it.body } + program.subs.map { it.body } +
            program.functions.values.filter { !it.isOfApi }.map { it.body }
        val started = bodies.flatMap { startsIn(it) }.toSet()
        for (task in program.tasks.filter { it.name != MAIN && it.name !in started }) {
            sink.report(NqcDiagnosticCode.TASK_NEVER_STARTED, task.range, sink.messages.taskNeverStarted(task.name))
        }
    }

    private fun startsIn(statement: Statement): List<String> {
        val own = (statement as? Statement.TaskCommand)?.takeIf { it.isStart }?.task
        return listOfNotNull(own) + statement.parts.flatMap { startsIn(it) }
    }

    private fun reportMissingMain(end: SourceRange) {
        val similar = program.tasks.find { similarName(MAIN, listOf(it.name)) != null }
        val range = similar?.range ?: SourceRange(1, 1, 1, end.file)
        val fix = similar?.let { SourceFix(it.range, MAIN) } ?: mainAt(end).takeIf { program.tasks.isEmpty() }
        sink.report(NqcDiagnosticCode.MAIN_MISSING, range, sink.messages.mainMissing(similar?.name), fix)
    }

    private fun mainAt(end: SourceRange): SourceFix? =
        SourceFix(end, if (end.column == 1) "$MAIN_TASK\n" else "\n\n$MAIN_TASK").takeIf { !sink.hasErrors }

    private companion object {
        const val MAIN_TASK = "task main()\n{\n    \n}"
        const val MAIN = "main"
    }
}
