package robotran.nqc.preprocess

import robotran.language.source.SourceFix
import robotran.nqc.config.NqcLimits
import robotran.nqc.diagnostic.DiagnosticSink
import robotran.nqc.diagnostic.NqcDiagnosticCode
import robotran.nqc.syntax.Token
import robotran.nqc.syntax.TokenKind
import robotran.nqc.syntax.similarName

/**
 * Follows the directives of a program and replaces its macros. Never throws.
 *
 * @param files the texts of the program's files by name.
 * @param predefined the macros that exist from the beginning.
 */
internal class Preprocessor(
    files: Map<String, String>,
    predefined: Map<String, Macro>,
    private val sink: DiagnosticSink,
) {
    private val source = TokenSource(files, sink) { conditions.isActive }
    private val macros = HashMap(predefined)
    private val replacer = MacroReplacer(source, macros, sink)
    private val conditions = Conditions()
    private val definitions = MacroDefinitions(macros, sink)
    private val pragmas = PragmaReader(sink)
    private val tokens = mutableListOf<Token>()

    /** Reads the program that begins with [main], which must be one of the files. */
    fun read(main: String): PreprocessedProgram {
        source.open(main)
        while (true) {
            val token = replacer.next(conditions.isActive)
            when {
                token.kind == TokenKind.END -> return finished(token)
                token.kind == TokenKind.DIRECTIVE -> follow(token)
                token.kind == TokenKind.END_OF_DIRECTIVE -> Unit
                conditions.isActive -> tokens += token
            }
            if (tokens.size > NqcLimits.TOKENS) {
                sink.report(NqcDiagnosticCode.SOURCE_TOO_LONG, token.range, sink.messages.programTooLong())
                return finished(token.copy(kind = TokenKind.END, text = ""))
            }
        }
    }

    private fun finished(end: Token): PreprocessedProgram {
        conditions.innermost?.let {
            sink.report(NqcDiagnosticCode.UNTERMINATED_IF, it, sink.messages.unterminatedIf())
        }
        return PreprocessedProgram(tokens + end, pragmas.result(), macros)
    }

    private fun follow(directive: Token) {
        when (directive.text) {
            "ifdef" -> beginIf(directive) { isDefined(directive) }
            "ifndef" -> beginIf(directive) { !isDefined(directive) }
            "if" -> beginIf(directive) { isTrue(directive) }
            "elif" -> elseIf(directive)
            "else" -> check(conditions.next(isTrue = true, isElse = true), directive)
            "endif" -> check(conditions.end(), directive)
            else -> if (conditions.isActive) act(directive) else restOfLine()
        }
        if (directive.text in ENDING) restOfLine()
    }

    private fun act(directive: Token) = when (directive.text) {
        "include" -> include(directive)
        "define" -> definitions.define(directive, restOfLine())
        "undef" -> definitions.undefine(directive, restOfLine())
        "pragma" -> pragmas.read(directive, restOfLine())

        "error" -> {
            sink.report(
                NqcDiagnosticCode.ERROR_DIRECTIVE,
                directive.range,
                sink.messages.errorDirective(textOf(restOfLine())),
            )
        }

        "warning" -> {
            sink.report(
                NqcDiagnosticCode.WARNING_DIRECTIVE,
                directive.range,
                sink.messages.warningDirective(textOf(restOfLine())),
            )
        }

        else -> {
            restOfLine()
            val similar = similarName(directive.text, DIRECTIVES)
            sink.report(
                NqcDiagnosticCode.UNKNOWN_DIRECTIVE,
                directive.range,
                sink.messages.unknownDirective(directive.text),
                similar?.let { SourceFix(directive.range, "#$it") },
            )
        }
    }

    private fun include(directive: Token) {
        val line = restOfLine()
        val name = line.firstOrNull()?.takeIf { it.kind == TokenKind.TEXT }
        if (name == null) {
            val range = line.firstOrNull()?.range ?: directive.range.end
            sink.report(NqcDiagnosticCode.INCLUDE_NEEDS_NAME, range, sink.messages.includeNeedsName(), quoting(line))
        } else if (!source.has(name.text)) {
            sink.report(NqcDiagnosticCode.FILE_NOT_FOUND, name.range, sink.messages.fileNotFound(name.text))
        } else if (!source.open(name.text)) {
            sink.report(NqcDiagnosticCode.TOO_MANY_INCLUDES, name.range, sink.messages.tooManyIncludes())
        }
    }

    /** The fix that puts the name of an `#include` in quotation marks. */
    private fun quoting(line: List<Token>): SourceFix? {
        if (line.isEmpty()) return null
        val name = line.joinToString("") { it.text }.removePrefix("<").removeSuffix(">")
        return SourceFix(line.first().range.to(line.last().range), "\"$name\"")
    }

    private fun beginIf(directive: Token, condition: () -> Boolean) {
        val isTrue = if (conditions.isActive) condition() else false
        if (!conditions.isActive) restOfLine()
        conditions.begin(directive.range, isTrue)
    }

    private fun elseIf(directive: Token) {
        val isTrue = if (conditions.needsElif) isTrue(directive) else false.also { restOfLine() }
        check(conditions.next(isTrue, isElse = false), directive)
    }

    private fun check(hasIf: Boolean, directive: Token) {
        if (hasIf) return
        sink.report(NqcDiagnosticCode.ELSE_WITHOUT_IF, directive.range, sink.messages.elseWithoutIf(directive.text))
    }

    private fun isDefined(directive: Token): Boolean {
        val name = restOfLine().firstOrNull()?.takeIf { it.kind == TokenKind.NAME }
        if (name == null) {
            sink.report(
                NqcDiagnosticCode.DIRECTIVE_NEEDS_NAME,
                directive.range.end,
                sink.messages.directiveNeedsName(directive.text),
            )
        }
        return name != null && name.text in macros
    }

    private fun isTrue(directive: Token): Boolean {
        val line = conditionLine()
        val reader = ConditionReader(line) { it in macros }
        val value = reader.read()
        reader.fault?.let {
            val range = line.firstOrNull()?.range?.to(line.last().range) ?: directive.range.end
            sink.report(it, range, sentenceAbout(it))
        }
        return value != 0
    }

    private fun sentenceAbout(fault: NqcDiagnosticCode): String = when (fault) {
        NqcDiagnosticCode.CONDITION_INCOMPLETE -> sink.messages.conditionIncomplete()
        NqcDiagnosticCode.CONDITION_BRACKETS -> sink.messages.conditionBrackets()
        else -> sink.messages.conditionSyntax()
    }

    /** The rest of the line with its macros replaced, but not those in `defined(..)`. */
    private fun conditionLine(): List<Token> {
        val line = mutableListOf<Token>()
        while (line.size <= NqcLimits.TOKENS) {
            val isName =
                line.size >= 2 && line[line.size - 2].text == ConditionReader.DEFINED && line.last().isSign("(")
            val token = replacer.next(!isName)
            if (token.kind == TokenKind.END || token.kind == TokenKind.END_OF_DIRECTIVE) break
            line += token
        }
        return line
    }

    private fun restOfLine(): List<Token> {
        val line = mutableListOf<Token>()
        while (true) {
            val token = source.next()
            if (token.kind == TokenKind.END || token.kind == TokenKind.END_OF_DIRECTIVE) return line
            line += token
        }
    }

    private fun textOf(line: List<Token>): String = line.joinToString(" ") { it.text }.take(NqcLimits.QUOTED_CHARACTERS)

    private companion object {
        /** Directives whose line has nothing more to say. */
        val ENDING = setOf("else", "endif")

        val DIRECTIVES =
            listOf(
                "define",
                "undef",
                "include",
                "if",
                "ifdef",
                "ifndef",
                "elif",
                "else",
                "endif",
                "pragma",
                "error",
                "warning",
            )
    }
}
