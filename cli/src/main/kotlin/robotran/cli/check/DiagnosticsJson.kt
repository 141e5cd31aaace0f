package robotran.cli.check

import kotlinx.serialization.json.JsonArray
import kotlinx.serialization.json.JsonObject
import kotlinx.serialization.json.JsonObjectBuilder
import kotlinx.serialization.json.buildJsonObject
import kotlinx.serialization.json.put
import robotran.cli.console.jsonOutput
import robotran.cli.files.nameOf
import robotran.cli.input.RobolangFile
import robotran.json.JsonWarning
import robotran.language.source.Diagnostic
import robotran.language.source.Severity
import robotran.language.source.SourceFix
import robotran.language.source.SourceRange

/**
 * The output of `robotran check --json`: a list with one object per file. Each object has `file` and either
 * `diagnostics` or, if the file cannot be read, `error`. A program that can run has only warnings. Lines and columns
 * start at 1; `endColumn` is exclusive. Only Robolang errors have a `code`. A diagnostic of a file that a program in NQC
 * includes has its `file`; one of a world, robot, project or course has a `path` and no column.
 */
internal fun diagnosticsJson(files: List<Pair<String, CheckedFile>>): String =
    jsonOutput.encodeToString(JsonArray.serializer(), JsonArray(files.map { (name, file) -> json(name, file) }))

private fun json(name: String, file: CheckedFile): JsonObject = buildJsonObject {
    put("file", name)
    when (file) {
        is CheckedFile.Unreadable -> put("error", file.reason)
        else -> put("diagnostics", JsonArray(file.notes.map { json("warning", JsonWarning(it)) } + rows(name, file)))
    }
}

private fun rows(name: String, file: CheckedFile): List<JsonObject> = when (file) {
    is CheckedFile.Robolang -> {
        diagnosticsOf(file.file).map(::jsonOfRobolang) +
            file.translated.map { json(if (file.isForBrick) "mistake" else "warning", it) }
    }

    is CheckedFile.Java -> file.diagnostics.map { json("mistake", it) } + file.warnings.map { json("warning", it) }

    is CheckedFile.Firmware -> {
        file.diagnostics.map { json("mistake", it, name) } + file.warnings.map { json("warning", it, name) }
    }

    is CheckedFile.Described -> {
        listOfNotNull(file.error).map { json("mistake", it) } + file.warnings.map { json("warning", it) }
    }

    is CheckedFile.Unreadable -> emptyList()
}

private fun json(severity: String, found: JsonWarning): JsonObject = buildJsonObject {
    put("severity", severity)
    found.line?.let { put("line", it) }
    if (found.path.isNotEmpty()) put("path", found.path)
    put("message", found.message)
}

private fun diagnosticsOf(file: RobolangFile): List<Diagnostic> = when (file) {
    is RobolangFile.Ready -> file.warnings
    is RobolangFile.HasErrors -> file.diagnostics
    is RobolangFile.Unreadable -> emptyList()
}

/** @param checked the checked file, if others may be named that it includes. */
private fun json(severity: String, diagnostic: Diagnostic, checked: String? = null): JsonObject = buildJsonObject {
    put("severity", severity)
    if (checked != null && nameOf(diagnostic.file) != nameOf(checked)) put("file", diagnostic.file)
    diagnostic.range?.let { put(it) }
    put("message", diagnostic.message)
    diagnostic.fix?.let { put("fix", json(it)) }
}

private fun jsonOfRobolang(diagnostic: Diagnostic): JsonObject = buildJsonObject {
    diagnostic.code?.let { put("code", it.id) }
    put("severity", if (diagnostic.severity == Severity.ERROR) "mistake" else "warning")
    diagnostic.range?.let { put(it) }
    put("text", diagnostic.text)
    put("message", diagnostic.message)
    diagnostic.fix?.let { put("fix", json(it)) }
}

private fun json(fix: SourceFix): JsonObject = buildJsonObject {
    put(fix.range)
    put("replacement", fix.replacement)
}

private fun JsonObjectBuilder.put(range: SourceRange) {
    put("line", range.line)
    put("column", range.column)
    put("endColumn", range.endColumn)
}
