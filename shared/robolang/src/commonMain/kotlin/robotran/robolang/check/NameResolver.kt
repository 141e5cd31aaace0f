package robotran.robolang.check

import robotran.language.source.SourceFix
import robotran.language.source.SourceRange
import robotran.robolang.diagnostic.DiagnosticCode
import robotran.robolang.syntax.AssignTarget
import robotran.robolang.syntax.BuiltIn
import robotran.robolang.syntax.Expression
import robotran.robolang.syntax.Name
import robotran.robolang.syntax.RobolangLimits
import robotran.robolang.syntax.Routine
import robotran.robolang.syntax.Statement
import robotran.robolang.syntax.bodies
import robotran.robolang.syntax.expressions
import robotran.robolang.syntax.shortened

/** Resolves all names, and adds the type constraints between expressions. */
internal class NameResolver(private val context: CheckContext) {
    private val scopes = Scopes()
    private val types = TypeConstraints(context, ::resolveRead)
    private val messages = context.messages
    private val slots = mutableMapOf<SourceRange?, Int>()
    private val room = VariableBudget(context)
    private val globals = mutableMapOf<String, UnresolvedSymbol>()
    private var owner: Routine? = null
    private var depth = 0

    fun resolve() {
        context.tree.routines.forEachIndexed(::declareRoutine)
        statements(context.tree.statements)
        for (routine in context.tree.routines) inOwnScope(routine) { routine(routine) }
        for (behaviour in context.tree.behaviours) {
            inOwnScope(null) {
                types.of(behaviour.condition)
                statements(behaviour.body)
            }
        }
        connectCalls()
    }

    /** Arguments flow to parameters. */
    private fun connectCalls() {
        for (call in context.calls) {
            val parameters = context.routineOf(call.name)?.parameters.orEmpty()
            parameters.zip(call.arguments).forEach { (parameter, argument) ->
                context.draftsByName[parameter.range]?.let { types.of(argument).flowTo(it.type) }
            }
        }
    }

    private fun declareRoutine(place: Int, routine: Routine) {
        val kind = if (routine.isFunction) SymbolKind.FUNCTION else SymbolKind.PROCEDURE
        val draft = UnresolvedSymbol(routine.name, kind, owner = null, index = place, isGlobal = true)
        val earlier = context.routines[routine.name.key]
        when {
            routine.name.text.isEmpty() -> return

            BuiltIn.of(
                routine.name.key,
            ) != null -> reportTaken(routine.name, messages.declaredBuiltIn(shortened(routine.name.text)))

            earlier != null -> reportTaken(
                routine.name,
                messages.declaredTwice(shortened(routine.name.text), earlier.name.range.line),
            )

            else -> context.routines[routine.name.key] = draft
        }
        context.drafts += draft
        context.draftsByName[routine.name.range] = draft
        context.routinesByName[routine.name.range] = routine
        if (place == RobolangLimits.ROUTINES) {
            context.report(
                DiagnosticCode.TOO_MANY_ROUTINES,
                routine.name.range,
                messages.tooManyRoutines(RobolangLimits.ROUTINES),
            )
        }
    }

    private fun reportTaken(name: Name, message: String) {
        context.report(DiagnosticCode.DECLARED_TWICE, name.range, message)
    }

    private fun routine(routine: Routine) {
        owner = routine
        for (parameter in routine.parameters) {
            val earlier = scopes[parameter.key]?.takeIf { it.owner?.range == routine.range }
            if (earlier != null) {
                reportTaken(parameter, messages.declaredTwice(shortened(parameter.text), earlier.name.range.line))
            }
            declare(parameter, SymbolKind.PARAMETER)
        }
        routine.parameters.getOrNull(RobolangLimits.PARAMETERS)?.let {
            context.report(
                DiagnosticCode.TOO_MANY_PARAMETERS,
                it.range,
                messages.tooManyParameters(RobolangLimits.PARAMETERS),
            )
        }
        types.current = context.draftsByName[routine.name.range]
        statements(routine.body)
        types.current = null
        owner = null
    }

    private fun inOwnScope(routine: Routine?, resolve: () -> Unit) {
        depth++
        scopes.enter()
        resolve()
        scopes.leave()
        depth--
    }

    private fun statements(statements: List<Statement>) {
        statements.forEach(::statement)
    }

    private fun statement(statement: Statement) = room.around(statement, owner) {
        statement.expressions.forEach(types::of)
        when (statement) {
            is Statement.Declare -> declare(statement)
            is Statement.Assign -> assign(statement)
            is Statement.Call -> types.call(statement.name, statement.arguments)
            is Statement.Return -> types.giveBack(statement)
            is Statement.ForRange -> loop(statement.body) { declareCounter(statement) }
            is Statement.ForEach -> loop(statement.body) { declareElement(statement) }
            else -> statement.bodies.forEach { loop(it) {} }
        }
    }

    private fun loop(body: List<Statement>, declareVariable: () -> Unit) {
        depth++
        scopes.enter()
        declareVariable()
        statements(body)
        scopes.leave()
        depth--
    }

    private fun declareCounter(statement: Statement.ForRange) {
        val draft = declareNew(statement.variable, SymbolKind.LOOP_VARIABLE)
        for (number in listOfNotNull(
            statement.from,
            statement.to,
            statement.step,
        )) {
            types.of(number).flowTo(draft.type, TypeConstraint.NUMBER)
        }
    }

    private fun declareElement(statement: Statement.ForEach) {
        val draft = declareNew(statement.variable, SymbolKind.LOOP_VARIABLE)
        types.of(statement.list).flowTo(draft.type, TypeConstraint.ELEMENT)
    }

    private fun declare(statement: Statement.Declare) {
        val draft = declareNew(statement.name, if (statement.isConstant) SymbolKind.CONSTANT else SymbolKind.VARIABLE)
        types.of(statement.value).flowTo(draft.type)
        context.declaredValues[statement.name.range] = statement.value
        if (statement.isConstant) draft.constant = context.constantOf(statement.value)
        draft.listLength = (statement.value as? Expression.ListOf)?.elements?.size
    }

    private fun declareNew(name: Name, kind: SymbolKind): UnresolvedSymbol {
        val earlier = scopes[name.key]?.takeIf { it.owner?.range == owner?.range && !context.isExcused(name) }
        if (earlier != null) {
            val isBoth = kind == SymbolKind.VARIABLE && earlier.kind == SymbolKind.VARIABLE
            val line = earlier.name.range.line
            val text = shortened(name.text)
            reportTaken(name, if (isBoth) messages.redeclared(text, line) else messages.declaredTwice(text, line))
        }
        return declare(name, kind)
    }

    private fun declare(name: Name, kind: SymbolKind): UnresolvedSymbol {
        val slot = slots[owner?.range] ?: 0
        slots[owner?.range] = slot + 1
        val draft = UnresolvedSymbol(name, kind, owner, slot, isGlobal = depth == 0)
        scopes.declare(draft)
        context.drafts += draft
        context.draftsByName[name.range] = draft
        if (draft.isGlobal) globals[name.key] = globals[name.key] ?: draft
        if (draft.isGlobal) room.field(name.range) else room.local(owner, name.range)
        return draft
    }

    private fun assign(statement: Statement.Assign) {
        when (val target = statement.target) {
            is AssignTarget.Variable -> resolve(target.name, isAssigned = true)?.let { it.isAssigned = true }
            is AssignTarget.ListElement -> resolveRead(target.list)
        }
    }

    private fun resolveRead(name: Name): UnresolvedSymbol? = resolve(name)?.also { it.isRead = true }

    private fun resolve(name: Name, isAssigned: Boolean = false): UnresolvedSymbol? {
        val draft = scopes[name.key]
        val isBelow = draft != null && draft.isGlobal && draft.name.range.line > name.range.line
        if (draft != null && !isBelow) {
            context.draftsByName[name.range] = draft
            return draft
        }
        if (context.isExcused(name)) return null
        val later = draft ?: declaredBelow(name)
        if (later != null) {
            val message = messages.usedBeforeDeclaration(shortened(name.text), later.name.range.line)
            context.report(DiagnosticCode.USED_BEFORE_DECLARATION, name.range, message)
        } else {
            reportUnknown(name, isAssigned)
        }
        return null
    }

    private fun reportMissingBrackets(name: Name) {
        context.report(
            DiagnosticCode.MISSING_BRACKETS,
            name.range,
            messages.missingBracketsOfCall(shortened(name.text)),
        )
    }

    /** In other languages this declares a variable. */
    private fun reportUndeclared(name: Name) {
        val start = name.range.copy(endColumn = name.range.column)
        val message = messages.undeclaredVariable(shortened(name.text))
        context.report(DiagnosticCode.UNKNOWN_VARIABLE, name.range, message, SourceFix(start, "var "))
    }

    private fun declaredBelow(name: Name): UnresolvedSymbol? = globals[name.key] ?: declaredGlobally[name.key]

    private val declaredGlobally: Map<String, UnresolvedSymbol> by lazy {
        context.tree.statements.filterIsInstance<Statement.Declare>().associate { statement ->
            statement.name.key to
                UnresolvedSymbol(statement.name, SymbolKind.VARIABLE, owner = null, index = 0, isGlobal = true)
        }
    }

    private fun reportUnknown(name: Name, isAssigned: Boolean) {
        if (name.key in context.routines || BuiltIn.of(name.key) != null) return reportMissingBrackets(name)
        val meant = context.nearestName(name, scopes)
        if (meant == null && isAssigned) return reportUndeclared(name)
        val message = messages.unknownVariable(shortened(name.text), meant)
        val only = meant?.takeUnless { context.isOneOfSeveral(name, it, scopes) }
        context.report(DiagnosticCode.UNKNOWN_VARIABLE, name.range, message, only?.let { SourceFix(name.range, it) })
    }
}
