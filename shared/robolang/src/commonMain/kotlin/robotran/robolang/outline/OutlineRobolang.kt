package robotran.robolang.outline

import robotran.brick.kind.BrickKind
import robotran.language.source.Diagnostic
import robotran.language.source.SourceRange
import robotran.language.source.SourceSpan
import robotran.robolang.diagnostic.DiagnosticCode
import robotran.robolang.diagnostic.DiagnosticSink
import robotran.robolang.messages.RobolangMessages
import robotran.robolang.syntax.ParsedProgram
import robotran.robolang.syntax.RobolangLimits
import robotran.robolang.syntax.parse
import robotran.robolang.words.LineForm
import robotran.robolang.words.Vocabulary
import robotran.robolang.words.vocabularyOf

/**
 * Reads a Robolang program line by line, in time linear in its length. Never throws for any [source]. Only the scanner's
 * and the parser's mistakes are reported; a program with an undeclared name, for example, has none.
 *
 * @param messages the mistakes in the pupil's language.
 * @param vocabulary the words that it is written in, if that cannot be told from [source], as from a single value.
 * @param brick the brick of the robot that it is for, unless its header names another one.
 */
fun outlineRobolang(
    source: String,
    messages: RobolangMessages,
    vocabulary: Vocabulary = vocabularyOf(source),
    brick: BrickKind = BrickKind.default,
): ProgramOutline {
    if (source.length > RobolangLimits.SOURCE_CHARACTERS) return tooLong(source, brick, DiagnosticSink(messages))
    val parsed = parse(source, brick, messages, vocabulary)
    val program = parsed.program
    val offsets = LineOffsets(source, program.lines)
    return ProgramOutline(source, brick, linesOf(program, offsets, parsed.diagnostics()), parsed) {
        declaredNames(it, program, offsets, parsed.diagnostics())
    }
}

private fun tooLong(source: String, brick: BrickKind, diagnostics: DiagnosticSink): ProgramOutline {
    val message = diagnostics.messages.sourceTooLong(RobolangLimits.SOURCE_CHARACTERS)
    diagnostics.report(DiagnosticCode.SOURCE_TOO_LONG, SourceRange(1, 1, 1), "", message)
    val line = OutlineLine(
        index = 0,
        SourceSpan(0, source.length),
        source.length,
        LineRole.PLAIN,
        depth = 0,
        form = null,
        parts = emptyList(),
        comment = null,
        diagnostics.errorsInSourceOrder().single(),
    )
    return ProgramOutline(source, brick, listOf(line), parsed = null) { emptyList() }
}

private fun linesOf(parsed: ParsedProgram, offsets: LineOffsets, diagnostics: DiagnosticSink): List<OutlineLine> {
    val places = BlockStructure(parsed.lines, parsed.edges, parsed.lackingEnds).places()
    val phrases = LinePhrases(parsed.tree)
    val errors: Map<Int?, Diagnostic> = diagnostics.errorsInSourceOrder().associateBy { it.range?.line }
    return parsed.lines.mapIndexed { index, line ->
        val place = places[index]
        val error = errors[line.number]
        val hasError = line.number in diagnostics.lines && error?.code !in ABOUT_BLOCKS
        val phrase = when {
            hasError || line.tokens.isEmpty() -> null
            place.role == LineRole.CLOSES -> LinePhrase(LineForm.END)
            else -> phrases[line.number]
        }
        val parts = phrase?.let {
            PhraseBuilder(line.tokens, offsets, diagnostics.brick).line(it.form.choices, it.claims)
        }
        OutlineLine(
            index,
            offsets.line(index),
            offsets.end(index),
            place.role,
            place.depth,
            phrase?.form.takeIf { parts != null },
            parts.orEmpty(),
            line.comment?.let { offsets.span(it.range) },
            error,
        )
    }
}

/** Mistakes about where a line stands; what it says is clear. */
private val ABOUT_BLOCKS = setOf(DiagnosticCode.MISSING_END, DiagnosticCode.NOT_OUTERMOST, DiagnosticCode.SECOND_ROBOT)
