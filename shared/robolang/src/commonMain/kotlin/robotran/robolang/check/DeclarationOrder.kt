package robotran.robolang.check

import robotran.language.source.SourceRange
import robotran.robolang.diagnostic.DiagnosticCode
import robotran.robolang.syntax.Name
import robotran.robolang.syntax.leadingDeclarations
import robotran.robolang.syntax.shortened

/**
 * Finds possible uses of a global before its declaration: a call of a routine that uses a global declared further down,
 * and a behaviour, which may run as soon as the first declarations are done. Considers every possible call path.
 */
internal class DeclarationOrder(private val context: CheckContext, private val graph: CallGraph) {
    private val messages = context.messages
    private val toldOfBehaviours = mutableSetOf<UnresolvedSymbol>()

    fun check() {
        if (context.parsed.isUncertain) return
        for (statement in context.tree.statements) {
            for (call in Uses().apply { add(statement) }.calls) {
                val routine = context.routineOf(call) ?: continue
                val global = graph.latestGlobal(routine)?.takeIf { lineOf(it) >= call.range.line } ?: continue
                report(call.range, global, messageOf(call, global))
            }
        }
        checkBehaviours()
    }

    private fun messageOf(call: Name, global: UnresolvedSymbol): String {
        val routine = shortened(call.text)
        val variable = shortened(global.name.text)
        return if (lineOf(global) == call.range.line) {
            messages.calledInDeclaration(routine, variable)
        } else {
            messages.calledBeforeDeclaration(routine, variable, lineOf(global))
        }
    }

    private fun checkBehaviours() {
        val declared = context.tree.leadingDeclarations.lastOrNull()?.range?.line ?: 0
        for (behaviour in context.tree.behaviours) {
            val uses = Uses().apply {
                add(behaviour.condition)
                add(behaviour.body)
            }
            val direct = uses.variables.map { it to context.globalOf(it) }
            val called = uses.calls.map { call -> call to context.routineOf(call)?.let(graph::latestGlobal) }
            for ((name, global) in direct + called) {
                if (global != null && lineOf(global) > declared && toldOfBehaviours.add(global)) {
                    report(
                        name.range,
                        global,
                        messages.neededBeforeDeclaration(shortened(global.name.text), lineOf(global)),
                    )
                }
            }
        }
    }

    private fun lineOf(global: UnresolvedSymbol): Int = global.name.range.line

    private fun report(range: SourceRange, global: UnresolvedSymbol, message: String) {
        if (!context.isExcused(global.name)) context.report(DiagnosticCode.USED_BEFORE_DECLARATION, range, message)
    }
}
