package robotran.nqc.parse

import robotran.language.othersOfSeries
import robotran.language.source.SourceFix
import robotran.language.source.SourceRange
import robotran.legofirmware.image.FirmwareTarget
import robotran.nqc.diagnostic.API_RANGE
import robotran.nqc.diagnostic.NqcDiagnosticCode
import robotran.nqc.syntax.Keyword
import robotran.nqc.syntax.KeywordGroup
import robotran.nqc.syntax.Signs
import robotran.nqc.syntax.Token
import robotran.nqc.syntax.TokenKind
import robotran.nqc.syntax.onlySimilarName
import robotran.nqc.syntax.similarName
import robotran.nqc.tree.Variable

/**
 * Finds what names mean, and explains those that mean nothing.
 *
 * @param words all other names that a value can begin with.
 * @param declared the tasks, subroutines and functions of the program, also below.
 * @param functions the functions of the API.
 * @param isFunction whether there is a task, subroutine or function of a name so far.
 */
internal class NameResolver(
    private val reader: TokenReader,
    private val scopes: Scopes,
    private val target: FirmwareTarget,
    private val words: Set<String>,
    private val declared: DeclaredUnits,
    private val functions: Set<String>,
    private val isFunction: (String) -> Boolean,
    private val apiNames: ApiNames,
) {
    private val sink = reader.sink
    private val sensors = SensorNames(reader, words)
    private val unknown = Variable("", API_RANGE)

    /** The variable [name]; one that stands for it after a mistake. */
    fun variable(name: Token): Variable {
        val visible = scopes.variable(name.text)
        if (visible != null) {
            // As with the original, a pointer that nothing uses is no mistake.
            if (visible.isPointer) requirePointers(name.range)
            return visible
        }
        val text = name.text
        if (apiNames.needsSecondFirmware(text)) {
            val message = sink.messages.needsSecondFirmware(text)
            sink.report(NqcDiagnosticCode.UNDEFINED_VARIABLE, name.range, message)
            return unknown
        }
        val renamed = sensors.nameFor(text)
        val others = othersOfSeries(renamed ?: text, words)
        if (renamed !in words && others.isNotEmpty()) {
            val message = sink.messages.notOfSeries(text, others.take(MAX_NAMED))
            sink.report(NqcDiagnosticCode.UNDEFINED_VARIABLE, name.range, message)
            return unknown
        }
        val known = scopes.variableNames + words + VALUE_WORDS
        val similar = renamed ?: similarName(text, known)
        sink.report(
            NqcDiagnosticCode.UNDEFINED_VARIABLE,
            name.range,
            sink.messages.undefinedVariable(text, similar),
            when {
                name.macro != null -> null
                renamed != null -> SourceFix(name.range, renamed)
                similar != null -> onlySimilarName(text, known)?.let { SourceFix(name.range, it) }
                else -> declared.declaration(text, name.range).takeIf { isChanged(name) }
            },
        )
        return unknown
    }

    /** Whether [name] was read last and gets a value: then it is a variable and no misspelled constant. */
    private fun isChanged(name: Token): Boolean = reader.previous === name && reader.token.kind == TokenKind.SIGN &&
        (reader.token.text in Signs.ASSIGNMENTS || reader.token.text in STEPS)

    /** Whether [name] is a task of the program. */
    fun isTask(name: String): Boolean = declared.isTask(name)

    /** Whether [name] can be called. */
    fun isCallable(name: String): Boolean = name in functions || name in declared.names || name in words

    fun isUnknown(variable: Variable): Boolean = variable === unknown

    /** Whether here is a statement that is only a name, which means no variable. */
    fun isCommandAlone(): Boolean {
        val name = reader.token
        val next = reader.peek(1)
        val isAlone = next.kind == TokenKind.END || next.isSign(";") || next.isSign("}") ||
            (next.range.line != name.range.line && next.kind != TokenKind.SIGN)
        return isAlone && name.kind == TokenKind.NAME && scopes.variable(name.text) == null
    }

    /** Reports the statement [name], see [isCommandAlone]. */
    fun reportCommandAlone(name: Token) {
        val text = name.text
        val start = name.range.copy(endColumn = name.range.column)
        val call = callOf(text)
        val begun = functionsFrom(text)
        val known = scopes.variableNames + words + functions + declared.names
        val meant = begun.firstOrNull() ?: similarName(text, known)
        val only = if (begun.isEmpty()) onlySimilarName(text, known) else begun.singleOrNull()
        val (message, fix) = when {
            apiNames.needsSecondFirmware(text) -> sink.messages.needsSecondFirmware(text) to null
            declared.isTask(text) -> sink.messages.taskCalled(text) to SourceFix(start, "start ")
            call == "$text()" -> sink.messages.bracketsMissing(text, call) to SourceFix(name.range.end, "()")
            call != null -> sink.messages.bracketsMissing(text, call) to null
            else -> sink.messages.undefinedCommand(text, meant) to only?.let { SourceFix(name.range, it) }
        }
        sink.report(NqcDiagnosticCode.UNDEFINED_VARIABLE, name.range, message, fix.takeIf { name.macro == null })
    }

    /** Whether here is a name before a block, which means no variable, as in `forever { }`. */
    fun isBlockWord(): Boolean {
        val name = reader.token
        return name.kind == TokenKind.NAME && reader.peek(1).isSign("{") && scopes.variable(name.text) == null
    }

    /** Whether here is a statement such as `Wait 100`: a name that means no variable, and then a value. */
    fun isCallWithoutBrackets(): Boolean {
        val name = reader.token
        val next = reader.peek(1)
        val isValue = next.kind in VALUES || next.keyword?.group == KeywordGroup.VALUE
        return name.kind == TokenKind.NAME && isValue && next.range.line == name.range.line &&
            scopes.variable(name.text) == null
    }

    /** Reports the statement [name] with [arguments] that are in no brackets, see [isCallWithoutBrackets]. */
    fun reportCallWithoutBrackets(name: Token, arguments: SourceRange) {
        val text = name.text
        if (apiNames.needsSecondFirmware(text) || declared.isTask(text)) return reportCommandAlone(name)
        val isKnown = text in functions || text in declared.names
        val meant = if (isKnown) text else onlySimilarName(text, functions + declared.names)
        val call = reader.textAt(arguments)?.let { "$meant($it)" }.takeIf { meant != null && name.macro == null }
        val message = if (isKnown && call != null) {
            sink.messages.bracketsMissing(text, call)
        } else {
            sink.messages.undefinedCommand(text, meant)
        }
        val fix = call?.let { SourceFix(name.range.to(arguments), it) }
        sink.report(NqcDiagnosticCode.UNDEFINED_VARIABLE, name.range, message, fix)
    }

    /** How the function or subroutine [name] is called, without its arguments if the program has it; null for others. */
    private fun callOf(name: String): String? = when {
        name in functions -> apiNames.callOf(name) ?: "$name()"
        declared.isSub(name) -> "$name()"
        name in declared.names && !declared.isTask(name) -> "$name(..)"
        else -> null
    }

    /** The functions whose names begin with [beginning]; none for a single letter. */
    private fun functionsFrom(beginning: String): List<String> =
        functions.filter { beginning.length > 1 && it.startsWith(beginning, ignoreCase = true) }

    /** Fails because a call with this [name] is used like a value. */
    fun failAtCallAsValue(name: Token): Nothing {
        val text = name.text
        if (!isFunction(text)) sensors.failAtCall(name)
        when {
            isFunction(text) -> {
                reader.fail(NqcDiagnosticCode.CALL_AS_VALUE, name.range, sink.messages.callAsValue(text))
            }

            apiNames.needsSecondFirmware(text) -> {
                val message = sink.messages.needsSecondFirmware(text)
                reader.fail(NqcDiagnosticCode.UNDEFINED_FUNCTION, name.range, message)
            }

            else -> {
                val known = words + VALUE_WORDS
                val similar = similarName(text, known)
                reader.fail(
                    NqcDiagnosticCode.UNDEFINED_FUNCTION,
                    name.range,
                    sink.messages.undefinedFunction(text, similar),
                    onlySimilarName(text, known)?.takeIf { name.macro == null }?.let { SourceFix(name.range, it) },
                )
            }
        }
    }

    /** Reports a pointer or an array for a firmware that has none. */
    fun requirePointers(range: SourceRange) {
        if (target == FirmwareTarget.RCX) {
            sink.report(NqcDiagnosticCode.POINTER_UNSUPPORTED, range, sink.messages.pointerUnsupported())
        }
    }

    fun requireArrays(range: SourceRange) {
        if (target == FirmwareTarget.RCX) {
            sink.report(NqcDiagnosticCode.ARRAY_UNSUPPORTED, range, sink.messages.arrayUnsupported())
        }
    }

    fun requireFreeName(isFree: Boolean, name: Token) {
        if (isFree) return
        val message = sink.messages.redeclared(name.text, scopes.lineOf(name.text))
        sink.report(NqcDiagnosticCode.REDECLARED, name.range, message)
    }

    private companion object {
        /** Max names of a series that a message tells. */
        const val MAX_NAMED = 6
        val STEPS = setOf("++", "--")
        val VALUES = setOf(TokenKind.NAME, TokenKind.NUMBER, TokenKind.TEXT)
        val VALUE_WORDS = Keyword.entries.filter { it.group == KeywordGroup.VALUE }.map { it.text }
    }
}
