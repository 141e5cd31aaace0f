package robotran.textediting.complete

import robotran.language.ProgramLanguage
import robotran.textediting.text.Draft

/**
 * What may stand where the caret of [draft] is: words of the language, names of the program and what the brick's
 * library has. Null if nothing is offered there, as in a comment.
 *
 * @param isWanted whether somebody asked for it; otherwise nothing is offered before something has been typed.
 */
fun completionsAt(draft: Draft, language: ProgramLanguage, help: WordHelp, isWanted: Boolean): CompletionList? {
    if (!draft.selection.isEmpty) return null
    return when (language) {
        ProgramLanguage.ROBOLANG -> completeRobolang(draft, help, isWanted)
        ProgramLanguage.JAVA -> completeJava(draft, help, isWanted)
    }
}
