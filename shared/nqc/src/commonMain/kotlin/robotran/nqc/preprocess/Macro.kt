package robotran.nqc.preprocess

import robotran.nqc.syntax.Token

/**
 * What a name stands for.
 *
 * @property parameters null if the name takes no arguments; empty if it takes `()`.
 */
internal class Macro(val name: String, val parameters: List<String>?, val body: List<Token>)
