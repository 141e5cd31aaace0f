package robotran.textediting.complete

import robotran.brick.kind.BrickKind
import robotran.language.ProgramLanguage
import robotran.textediting.code.brickOfJava
import robotran.textediting.text.Draft

/**
 * The completions at the caret of [draft]: words of the language, names in the program and members of the brick's
 * library. Null if there are none, as in a comment.
 *
 * @param brick the brick of the robot; the header of a Robolang program or an import of Java may name another.
 * @param isExplicit whether the pupil asked for completions; otherwise they are offered only after a typed character.
 */
fun completionsAt(
    draft: Draft,
    language: ProgramLanguage,
    help: WordHelp,
    isExplicit: Boolean,
    brick: BrickKind,
): CompletionList? {
    if (!draft.selection.isEmpty) return null
    return when (language) {
        ProgramLanguage.ROBOLANG -> completeRobolang(draft, help, isExplicit, brick)
        ProgramLanguage.JAVA -> completeJava(draft, help, isExplicit, brickOfJava(draft.lines, brick))
        ProgramLanguage.NQC -> completeNqc(draft, help, isExplicit)
        ProgramLanguage.LASM -> completeLasm(draft, help, isExplicit)
    }
}
