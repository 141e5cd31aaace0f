package robotran.cli.check

import kotlinx.serialization.json.JsonArray
import kotlinx.serialization.json.JsonObject
import kotlinx.serialization.json.JsonObjectBuilder
import kotlinx.serialization.json.buildJsonObject
import kotlinx.serialization.json.put
import robotran.cli.console.jsonOutput
import robotran.cli.input.RobolangFile
import robotran.programs.ProgramDiagnostic
import robotran.robolang.diagnostic.Diagnostic
import robotran.robolang.diagnostic.Severity
import robotran.robolang.diagnostic.SourceRange

/**
 * What `robotran check --json` says: a list with one object a file, `file` and either `diagnostics`, only warnings for
 * a program that can run, or `error` for a file that cannot be read. Lines and columns count from 1, `endColumn` is
 * behind the last character. Only mistakes in Robolang have a `code`.
 */
internal fun diagnosticsJson(files: List<Pair<String, CheckedFile>>): String =
    jsonOutput.encodeToString(JsonArray.serializer(), JsonArray(files.map { (name, file) -> json(name, file) }))

private fun json(name: String, file: CheckedFile): JsonObject = buildJsonObject {
    put("file", name)
    when (file) {
        is CheckedFile.Robolang -> put("diagnostics", JsonArray(diagnosticsOf(file.file).map(::json)))

        is CheckedFile.Java -> put(
            "diagnostics",
            JsonArray(
                file.diagnostics.map {
                    json("mistake", it)
                } + file.warnings.map { json("warning", it) },
            ),
        )

        is CheckedFile.Unreadable -> put("error", file.reason)
    }
}

private fun diagnosticsOf(file: RobolangFile): List<Diagnostic> = when (file) {
    is RobolangFile.Ready -> file.warnings
    is RobolangFile.HasErrors -> file.diagnostics
    is RobolangFile.Unreadable -> emptyList()
}

private fun json(severity: String, diagnostic: ProgramDiagnostic): JsonObject = buildJsonObject {
    put("severity", severity)
    diagnostic.range?.let { put(it) }
    put("message", diagnostic.message)
    diagnostic.fix?.let { fix ->
        put(
            "fix",
            buildJsonObject {
                put(fix.range)
                put("replacement", fix.replacement)
            },
        )
    }
}

private fun json(diagnostic: Diagnostic): JsonObject = buildJsonObject {
    put("code", diagnostic.code.id)
    put("severity", if (diagnostic.severity == Severity.ERROR) "mistake" else "warning")
    put(diagnostic.range)
    put("text", diagnostic.text)
    put("message", diagnostic.message)
    diagnostic.fix?.let { fix ->
        put(
            "fix",
            buildJsonObject {
                put(fix.range)
                put("replacement", fix.replacement)
            },
        )
    }
}

private fun JsonObjectBuilder.put(range: SourceRange) {
    put("line", range.line)
    put("column", range.column)
    put("endColumn", range.endColumn)
}
