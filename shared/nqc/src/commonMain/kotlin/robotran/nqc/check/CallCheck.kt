package robotran.nqc.check

import robotran.language.source.SourceFix
import robotran.nqc.config.NqcLimits
import robotran.nqc.diagnostic.DiagnosticSink
import robotran.nqc.diagnostic.NqcDiagnosticCode
import robotran.nqc.parse.ApiNames
import robotran.nqc.parse.DeclaredUnits
import robotran.nqc.syntax.onlySimilarName
import robotran.nqc.syntax.similarName
import robotran.nqc.tree.FunctionUnit
import robotran.nqc.tree.ParsedProgram
import robotran.nqc.tree.Statement

/**
 * Checks who calls whom, before code is generated.
 *
 * @param declared what the program declares, also what could not be read.
 * @param start what comes before the main task.
 * @param macros their names, for suggestions.
 */
internal class CallCheck(
    private val program: ParsedProgram,
    private val declared: DeclaredUnits,
    private val start: Statement?,
    private val apiNames: ApiNames,
    private val macros: Set<String>,
    private val sink: DiagnosticSink,
) {
    private val taskNames = program.tasks.map { it.name }.toSet()
    private val subNames = program.subs.map { it.name }.toSet()
    private val subsOf = HashMap<FunctionUnit, Set<String>>()
    private val open = mutableListOf<FunctionUnit>()

    /** The subroutines that each task calls, itself or through functions; by the name of the task. */
    fun subsOfTasks(): Map<String, Set<String>> = program.tasks.associate { task ->
        val before = if (task.name == MAIN) start?.let { subsIn(it) }.orEmpty() else emptySet()
        task.name to before + subsIn(task.body)
    }

    /** Checks the subroutines, which must not call others. */
    fun checkSubs() = program.subs.forEach { checkSub(it.body) }

    private fun checkSub(body: Statement) {
        for (call in callsIn(body)) {
            if (subsOf(call).isNotEmpty()) {
                sink.report(NqcDiagnosticCode.NESTED_SUB, call.range, sink.messages.nestedSub(call.name))
            }
        }
    }

    /** The subroutines that [body] calls, itself or through functions. */
    fun subsIn(body: Statement): Set<String> = callsIn(body).flatMap { subsOf(it) }.toSet()

    private fun callsIn(statement: Statement): List<Statement.Call> {
        val calls = mutableListOf<Statement.Call>()
        collect(statement, calls)
        return calls
    }

    private fun collect(statement: Statement, calls: MutableList<Statement.Call>) {
        if (statement is Statement.Call) calls += statement
        statement.parts.forEach { collect(it, calls) }
    }

    /** The subroutines that [call] leads to. */
    private fun subsOf(call: Statement.Call): Set<String> {
        val function = program.functions[call.name]
        return when {
            call.name in subNames -> {
                checkCount(call, 0)
                setOf(call.name)
            }

            function != null -> {
                checkCount(call, function.parameters.size)
                subsOf(function, call)
            }

            else -> {
                reportUndefined(call)
                emptySet()
            }
        }
    }

    private fun subsOf(function: FunctionUnit, call: Statement.Call): Set<String> {
        subsOf[function]?.let { return it }
        if (function in open) {
            sink.report(NqcDiagnosticCode.RECURSION, call.range, sink.messages.recursion(function.name))
            return emptySet()
        }
        if (open.size >= NqcLimits.CALL_DEPTH) {
            val message = sink.messages.nestedTooDeeply(NqcLimits.CALL_DEPTH)
            sink.report(NqcDiagnosticCode.NESTED_TOO_DEEPLY, call.range, message)
            return emptySet()
        }
        open += function
        val subs = subsIn(function.body)
        open.removeAt(open.lastIndex)
        subsOf[function] = subs
        return subs
    }

    private fun checkCount(call: Statement.Call, count: Int) {
        if (call.arguments.size == count) return
        val message = sink.messages.argumentCount(call.name, count, call.arguments.size, patternOf(call.name))
        sink.report(NqcDiagnosticCode.ARGUMENT_COUNT, call.range, message)
    }

    private fun reportUndefined(call: Statement.Call) {
        val name = call.name
        if (name in taskNames) return reportTask(call)
        if (name in declared.names) return
        if (apiNames.needsSecondFirmware(name)) {
            val message = sink.messages.needsSecondFirmware(name)
            return sink.report(NqcDiagnosticCode.UNDEFINED_FUNCTION, call.range, message)
        }
        val known = program.functions.keys + subNames
        val similar = similarName(name, known)
        val only = if (similar == null) onlySimilarName(name, macros) else onlySimilarName(name, known)
        sink.report(
            NqcDiagnosticCode.UNDEFINED_FUNCTION,
            call.range,
            sink.messages.undefinedFunction(name, similar ?: similarName(name, macros)),
            only?.takeIf { !call.macro }?.let { SourceFix(call.range, it) },
        )
    }

    private fun reportTask(call: Statement.Call) {
        val isOnLine = call.end.file == call.range.file && call.end.line == call.range.line
        val fix = SourceFix(call.range.to(call.end), "start ${call.name}")
            .takeIf { isOnLine && call.arguments.isEmpty() && !call.macro }
        sink.report(NqcDiagnosticCode.UNDEFINED_FUNCTION, call.range, sink.messages.taskCalled(call.name), fix)
    }

    /** How the function or subroutine [name] is called. */
    private fun patternOf(name: String): String {
        val function = program.functions[name]
        val own = function?.parameters.orEmpty().joinToString(", ", "$name(", ")") { it.name }
        return if (function?.isOfApi == true) apiNames.callOf(name) ?: own else own
    }

    private companion object {
        const val MAIN = "main"
    }
}
