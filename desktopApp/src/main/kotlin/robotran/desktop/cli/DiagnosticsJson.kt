package robotran.desktop.cli

import kotlinx.serialization.json.JsonArray
import kotlinx.serialization.json.JsonObject
import kotlinx.serialization.json.JsonObjectBuilder
import kotlinx.serialization.json.buildJsonObject
import kotlinx.serialization.json.put
import robotran.robolang.Diagnostic
import robotran.robolang.SourceRange

/**
 * What `robotran check --json` says: a list with one object a file, `file` and either `diagnostics`, only warnings for a program that can
 * run, or `error` for a file that cannot be read. Lines and columns count from 1, `endColumn` is behind the last character.
 */
internal fun diagnosticsJson(files: List<Pair<String, RobolangFile>>): String =
    jsonOutput.encodeToString(JsonArray.serializer(), JsonArray(files.map { (name, file) -> json(name, file) }))

private fun json(
    name: String,
    file: RobolangFile,
): JsonObject =
    buildJsonObject {
        put("file", name)
        when (file) {
            is RobolangFile.Ready -> put("diagnostics", JsonArray(file.warnings.map(::json)))
            is RobolangFile.Mistaken -> put("diagnostics", JsonArray(file.diagnostics.map(::json)))
            is RobolangFile.Unreadable -> put("error", file.reason)
        }
    }

private fun json(diagnostic: Diagnostic): JsonObject =
    buildJsonObject {
        put("code", diagnostic.code.id)
        put("severity", diagnostic.severity.name.lowercase())
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
