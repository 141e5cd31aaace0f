package robotran.robolang.check

import robotran.language.source.SourceRange
import robotran.robolang.diagnostic.DiagnosticCode
import robotran.robolang.diagnostic.DiagnosticSink
import robotran.robolang.robot.RobotTarget
import robotran.robolang.syntax.BuiltIn
import robotran.robolang.syntax.ParsedProgram
import robotran.robolang.syntax.shortened

/** Checks a program after parsing: names, types, values, control flow and the limits of the brick. */
internal class Checker(private val robot: RobotTarget, private val diagnostics: DiagnosticSink) {
    fun check(parsed: ParsedProgram): CheckedProgram {
        val context = CheckContext(parsed, diagnostics)
        NameResolver(context).resolve()
        if (diagnostics.isEmpty) settleUnusedTypes(context)
        BrickChecker(context, robot.kind).check()
        ExpressionChecker(context).let { StatementChecker(context, it, robot).check() }
        ControlFlowChecker(context).check()
        val graph = CallGraph(context)
        DeclarationOrder(context, graph).check()
        LimitChecker(context, graph).check()
        EndlessRecursion(context).check()
        warnOfUnusedVariables(context)
        return CheckedProgram(
            parsed.tree,
            context.drafts.map { it.symbol() },
            context.nodes.mapValues { it.value.type },
            symbolsByName(context),
        )
    }

    /** A parameter without any call has the type that its uses require, a whole number by default. */
    private fun settleUnusedTypes(context: CheckContext) {
        ParameterTypeInference(context).settle()
        val open = context.drafts.filter { it.kind == SymbolKind.PARAMETER || it.kind == SymbolKind.FUNCTION }
        open.filter { it.type.type == ValueType.NOTHING }.forEach { it.type.raise(ValueType.WHOLE) }
    }

    private fun symbolsByName(context: CheckContext): Map<SourceRange, Symbol> {
        val symbols = context.drafts.associate { it.name.range to it.symbol() }
        val builtIns = mutableMapOf<String, Symbol>()
        return context.parsed.names.mapNotNull { name ->
            val draft = context.draftsByName[name.range]
            val symbol = if (draft != null) {
                symbols[draft.name.range]
            } else {
                BuiltIn.of(name.key)?.let { builtIns.getOrPut(name.key) { builtInSymbol(it) } }
            }
            symbol?.let { name.range to it }
        }.toMap()
    }

    private fun builtInSymbol(function: BuiltIn) = Symbol(
        function.text,
        SymbolKind.BUILT_IN,
        ValueType.NOTHING,
        declaredAt = null,
        owner = null,
        function.ordinal,
        isGlobal = true,
    )

    private fun warnOfUnusedVariables(context: CheckContext) {
        for (draft in context.drafts) {
            val counts = draft.kind == SymbolKind.VARIABLE || draft.kind == SymbolKind.CONSTANT
            if (counts && !draft.isRead) {
                context.warn(
                    DiagnosticCode.UNUSED_VARIABLE,
                    draft.name.range,
                    context.messages.unusedVariable(shortened(draft.name.text)),
                )
            }
        }
    }
}
