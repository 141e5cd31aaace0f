package robotran.blockediting

import robotran.language.Language
import robotran.language.source.SourceSpan
import robotran.languagesupport.CodeTokenKind
import robotran.robolang.RobolangWords
import robotran.robolang.messages.RobolangMessages
import robotran.robolang.outline.DeclaredName
import robotran.robolang.outline.PhrasePart
import robotran.robolang.outline.outlineRobolang
import robotran.robolang.robolangTokens
import robotran.robolang.words.Vocabulary
import robotran.robolang.words.written
import robotran.textediting.TextEdit

/**
 * Whether Robolang in [vocabulary] allows [text] as a name. It also allows its newer words, but lines that already use
 * such a word would say something else then, so blocks offer none of them.
 */
fun isName(text: String, vocabulary: Vocabulary = Vocabulary.ENGLISH): Boolean {
    if (RobolangWords.isNewerWord(text, vocabulary)) return false
    val declaration = vocabulary.written("var ") + "$text = 1"
    val line = outlineRobolang(declaration, RobolangMessages.of(Language.ENGLISH), vocabulary).lines
    return line.size == 1 && line.first().parts.any { it is PhrasePart.NamePart && it.span.length == text.length }
}

/** A name like [text] that the program does not have yet, such as `side2`. */
fun BlockProgram.freeName(text: String): String {
    val taken = outline.names.mapTo(mutableSetOf()) { it.key }
    if (keyOf(text) !in taken) return text
    return generateSequence(2) { it + 1 }.map { text + it }.first { keyOf(it) !in taken }
}

/** Renames a name in all lines that use it, also in those with a mistake. */
internal fun renamed(program: BlockProgram, edit: BlockEdit.Rename): BlockEditResult {
    val name = program.outline.names.firstOrNull { it.declaredAt == edit.declaredAt }
        ?: return refused(BlockEditError.NotFound)
    val new = edit.name.trim()
    if (!isName(new, program.vocabulary)) return refused(BlockEditError.NoName(new))
    val key = keyOf(new)
    val isTaken = key in RobolangWords.functions ||
        program.outline.names.any {
            it !== name && it.key == key && it.isRoutine == name.isRoutine &&
                overlaps(it.visibleAt, name.visibleAt)
        }
    if (isTaken) return refused(BlockEditError.NameTaken(new))
    val places = (name.uses + usesInErrors(program, name)).sortedBy { it.start }
    val changes = places.map { TextEdit(it.start, it.textIn(program.text), new) }
    val before = places.takeWhile { it.start < name.declaredAt.start }
    val start = name.declaredAt.start + before.sumOf { new.length - it.length }
    return resultOf(program, changes, SourceSpan(start, start + new.length))
}

private fun overlaps(one: IntRange, other: IntRange) = one.first <= other.last && other.first <= one.last

private fun usesInErrors(program: BlockProgram, name: DeclaredName): List<SourceSpan> {
    val known = program.outline.names.flatMapTo(mutableSetOf()) { it.uses }
    val lines = program.outline.lines.filter { it.form == null && it.error != null && it.index in name.visibleAt }
    return lines.flatMap { line ->
        val text = line.span.textIn(program.text)
        robolangTokens(text).filter { token ->
            val isCalled = text.drop(token.end).trimStart().startsWith("(")
            token.kind == CodeTokenKind.NAME && keyOf(text.substring(token.start, token.end)) == name.key &&
                isCalled == name.isRoutine
        }.map { SourceSpan(line.span.start + it.start, line.span.start + it.end) }
    }.filter { it !in known }
}

/** Names ignore the case of A to Z, and of no other letter. */
private fun keyOf(name: String): String = name.map { if (it in 'A'..'Z') it.lowercaseChar() else it }.joinToString("")
