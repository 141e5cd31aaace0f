package robotran.programs

import robotran.language.source.Diagnostic
import robotran.language.source.SourceFix

/**
 * Keeps of the fixes that a compiler suggests only those that help: after them, the program has fewer mistakes, and none
 * that it did not have before. They are tried out by [compile].
 */
internal class FixVerification(private val compile: (ProgramSource) -> ProgramResult) {
    /** [result] of compiling [source], with the fixes that help. The time is bounded: beyond it, fixes are dropped. */
    fun verified(source: ProgramSource, result: ProgramResult): ProgramResult = when (result) {
        is ProgramResult.Failure -> ProgramResult.Failure(verified(source, result.diagnostics, isError = true))
        is ProgramResult.Success -> result.copy(warnings = verified(source, result.warnings, isError = false))
    }

    private fun verified(source: ProgramSource, found: List<Diagnostic>, isError: Boolean) = buildList {
        val length = source.files.sumOf { it.text.length }
        var trials = (MAX_CHARACTERS / maxOf(1, length)).coerceAtLeast(1)
        for (diagnostic in found) {
            val fix = diagnostic.fix
            val isKept = fix == null || (trials-- > 0 && helps(source, diagnostic, fix, found, isError))
            add(if (isKept) diagnostic else diagnostic.copy(fix = null))
        }
    }

    private fun helps(
        source: ProgramSource,
        diagnostic: Diagnostic,
        fix: SourceFix,
        before: List<Diagnostic>,
        isError: Boolean,
    ): Boolean {
        val fixed = source.withFix(diagnostic.file, fix) ?: return false
        val after = when (val result = compile(fixed)) {
            is ProgramResult.Failure -> if (isError) result.diagnostics else return false
            is ProgramResult.Success -> if (isError) emptyList() else result.warnings
        }
        return isBetter(before, after, diagnostic.file, fix)
    }

    private companion object {
        /** Max characters that are compiled to try out the fixes of a program that is not longer itself. */
        const val MAX_CHARACTERS = 60_000
    }
}

/**
 * Whether a program that had the mistakes [before] has fewer of them [after] a [fix] of [file], and none that is new: at
 * most one is told in a line, and each must have been told there before.
 */
fun isBetter(before: List<Diagnostic>, after: List<Diagnostic>, file: String, fix: SourceFix): Boolean {
    val known = before.mapTo(mutableSetOf()) { keyOf(it, it.range?.line) }
    val added = fix.replacement.count { it == '\n' }
    return after.size < before.size && after.all { error ->
        val line = error.range?.line
        val lineBefore = when {
            line == null || error.file != file || line <= fix.range.line -> line
            line <= fix.range.line + added -> fix.range.line
            else -> line - added
        }
        keyOf(error, lineBefore) in known
    }
}

/** Numbers in a message may be those of lines, which move. */
private fun keyOf(diagnostic: Diagnostic, line: Int?) =
    Triple(diagnostic.file, line, diagnostic.message.filterNot { it in '0'..'9' })
