package robotran.nqc.edit

import robotran.languagesupport.Completion

/**
 * The completions at a place of a program.
 *
 * @property start where the completed word begins; it ends at the caret.
 * @property typed the part of the word that is written.
 * @property items what can be there, the likeliest first, whether or not it begins with [typed].
 */
data class NqcCompletions(val start: Int, val typed: String, val items: List<Completion>)
