package robotran.nqc.edit

import robotran.language.Language
import robotran.languagesupport.Completion
import robotran.languagesupport.CompletionKind
import robotran.legofirmware.image.FirmwareTarget
import robotran.nqc.api.ExpectedNames
import robotran.nqc.api.NqcApi
import robotran.nqc.api.NqcApiEntry
import robotran.nqc.api.NqcApiKind
import robotran.nqc.syntax.Keyword
import robotran.nqc.syntax.KeywordGroup

/**
 * What can be written at [caret] of the program [source]; null in comments, texts and numbers. Never throws.
 *
 * @param isOld whether the API is that of NQC 1.3.
 */
fun completeNqc(
    source: String,
    caret: Int,
    language: Language,
    target: FirmwareTarget = FirmwareTarget.RCX2,
    isOld: Boolean = false,
): NqcCompletions? {
    val place = CaretPlace.of(source, caret) ?: return null
    val api = NqcApi.of(target, isOld)
    val candidates = Candidates(nqcNamesIn(source).filter { !place.isAt(it) }, api, language)
    val items = when (place.context) {
        CaretContext.DIRECTIVE -> candidates.directives()
        CaretContext.TASK_NAME -> candidates.names(NqcNameKind.TASK)
        CaretContext.OUTSIDE -> candidates.units()
        CaretContext.STATEMENT -> candidates.statements()
        CaretContext.VALUE -> candidates.expected(place.call, place.argument) + candidates.values()
        CaretContext.NEW_NAME -> emptyList()
    }
    return NqcCompletions(place.start, place.typed, items.distinctBy { it.label })
}

/** Everything that can be written somewhere in a program with the [names]. */
private class Candidates(
    private val names: List<NqcName>,
    private val api: Map<String, NqcApiEntry>,
    private val language: Language,
) {
    fun directives(): List<Completion> = DIRECTIVES.map { Completion("#$it", CompletionKind.WORD, "#$it ") }

    fun units(): List<Completion> = UNITS + words(KeywordGroup.DECLARATION) + words(KeywordGroup.UNIT) + directives()

    fun statements(): List<Completion> = calls() + entries(NqcApiKind.FUNCTION) + STATEMENTS +
        until() + names(NqcNameKind.VARIABLE) + names(NqcNameKind.MACRO) +
        words(KeywordGroup.STATEMENT) + words(KeywordGroup.DECLARATION)

    fun values(): List<Completion> = names(NqcNameKind.VARIABLE) + names(NqcNameKind.MACRO) +
        entries(NqcApiKind.VALUE).filter { !it.label.startsWith(UNTIL) } + entries(NqcApiKind.CONSTANT) +
        words(KeywordGroup.VALUE)

    /** The constants and sensors that argument number [argument] of the function [call] is made for. */
    fun expected(call: String?, argument: Int): List<Completion> {
        val entry = api[call] ?: return emptyList()
        return ExpectedNames.of(entry, argument).mapNotNull { api[it] }.map { completionOf(it) }
    }

    fun names(kind: NqcNameKind): List<Completion> =
        names.filter { it.kind == kind }.distinctBy { it.name }.map { Completion(it.name, CompletionKind.NAME) }

    private fun calls(): List<Completion> = names
        .filter { it.kind == NqcNameKind.SUB || it.kind == NqcNameKind.FUNCTION }
        .distinctBy { it.name }
        .map { Completion("${it.name}()", CompletionKind.FUNCTION, "${it.name}();", it.name.length + 1) }

    private fun entries(kind: NqcApiKind) =
        api.values.filter { it.kind == kind }.sortedByDescending { FIRST.indexOf(it.name) }.map { completionOf(it) }

    private fun until() = listOfNotNull(api[UNTIL]).map {
        Completion(it.signature, CompletionKind.WORD, "$UNTIL ();", UNTIL.length + 2, it.help(language))
    }

    private fun completionOf(entry: NqcApiEntry): Completion {
        val parameters = entry.parameters
        val kind = when (entry.kind) {
            NqcApiKind.FUNCTION -> CompletionKind.FUNCTION
            NqcApiKind.VALUE, NqcApiKind.CONSTANT -> CompletionKind.FIELD
        }
        val inserted = entry.name + (if (parameters == null) "" else "()") +
            (if (entry.kind == NqcApiKind.FUNCTION) ";" else "")
        val caret = if (parameters.isNullOrEmpty()) inserted.length else entry.name.length + 1
        return Completion(entry.signature, kind, inserted, caret, entry.help(language))
    }

    private fun words(group: KeywordGroup) = Keyword.entries.filter { it.group == group }
        .map { Completion(it.text, CompletionKind.WORD, help = nqcHelp(it.text, language)) }

    private companion object {
        const val UNTIL = "until"

        /** The functions that most programs need, the most usual ones last; the list begins with them. */
        val FIRST = listOf("PlayTone", "PlaySound", "SetPower", "SetSensor", "Wait", "Off", "OnRev", "OnFwd")

        val DIRECTIVES = "define include if ifdef ifndef elif else endif undef pragma error warning".split(' ')

        val UNITS = listOf(
            block("task main()", "task main()\n{\n    "),
            block("task", "task "),
            block("sub", "sub "),
            block("void", "void "),
        )

        val STATEMENTS = listOf(
            block("while ()", "while ("),
            block("repeat ()", "repeat ("),
            block("if ()", "if ("),
            block("for (;;)", "for ("),
            block("switch ()", "switch ("),
        )

        /** A block named [label]; the caret is at the end of [beginning]. */
        fun block(label: String, beginning: String): Completion {
            val text = when {
                beginning.endsWith("\n    ") -> "$beginning\n}"
                label.endsWith("()") -> "$beginning)\n{\n    \n}"
                label.startsWith("for") -> "$beginning; ; )\n{\n    \n}"
                else -> "$beginning()\n{\n    \n}"
            }
            return Completion("$label { }", CompletionKind.BLOCK, text, beginning.length)
        }
    }
}
