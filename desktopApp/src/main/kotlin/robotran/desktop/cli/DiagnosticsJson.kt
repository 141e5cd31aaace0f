package robotran.desktop.cli

import robotran.robolang.Diagnostic
import robotran.robolang.SourceFix
import robotran.robolang.SourceRange

/**
 * What `robotran check --json` says: a list with one object a file, `file` and either `diagnostics`, only warnings for a program that can
 * run, or `error` for a file that cannot be read. Lines and columns count from 1, `endColumn` is behind the last character.
 */
internal fun diagnosticsJson(files: List<Pair<String, RobolangFile>>): String =
    files.joinToString(",\n", "[\n", "\n]") { (name, file) ->
        val outcome =
            when (file) {
                is RobolangFile.Ready -> json(file.warnings)
                is RobolangFile.Mistaken -> json(file.diagnostics)
                is RobolangFile.Unreadable -> "\"error\": ${quoted(file.reason)}"
            }
        "  {\"file\": ${quoted(name)}, $outcome}"
    }

private fun json(diagnostics: List<Diagnostic>): String =
    "\"diagnostics\": " + if (diagnostics.isEmpty()) "[]" else diagnostics.joinToString(",\n", "[\n", "\n  ]", transform = ::json)

private fun json(diagnostic: Diagnostic): String {
    val fix = diagnostic.fix?.let { ", \"fix\": ${json(it)}" }.orEmpty()
    val kind = "\"code\": ${quoted(diagnostic.code.id)}, \"severity\": ${quoted(diagnostic.severity.name.lowercase())}"
    return "    {$kind, ${json(diagnostic.range)}, " +
        "\"text\": ${quoted(diagnostic.text)}, \"message\": ${quoted(diagnostic.message)}$fix}"
}

private fun json(fix: SourceFix): String = "{${json(fix.range)}, \"replacement\": ${quoted(fix.replacement)}}"

private fun json(range: SourceRange): String = "\"line\": ${range.line}, \"column\": ${range.column}, \"endColumn\": ${range.endColumn}"
