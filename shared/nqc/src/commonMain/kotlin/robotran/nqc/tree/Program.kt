package robotran.nqc.tree

import robotran.language.source.SourceRange
import robotran.nqc.config.ParameterLimit

/** @property range that of the name. */
internal class TaskUnit(val name: String, val body: Statement, val range: SourceRange)

/** A subroutine: code that tasks share. */
internal class SubUnit(val name: String, val body: Statement, val range: SourceRange)

/**
 * A function, which every call repeats.
 *
 * @property isOfApi whether it is predefined.
 * @property limits which constants make sense for each parameter; null for all.
 */
internal class FunctionUnit(
    val name: String,
    val parameters: List<Variable>,
    val range: SourceRange,
    val isOfApi: Boolean,
    val limits: List<ParameterLimit?>,
) {
    lateinit var body: Statement
}

/** A whole program, in the order of the source. */
internal class ParsedProgram(
    val globals: List<Statement.Declaration>,
    val tasks: List<TaskUnit>,
    val subs: List<SubUnit>,
    val functions: Map<String, FunctionUnit>,
)
