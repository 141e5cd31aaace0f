package robotran.nqc.preprocess

import robotran.language.source.SourceRange
import robotran.nqc.syntax.Token

/**
 * What the `#pragma` lines of a program ask for.
 *
 * @property hasInit whether anything is called before the main task's own commands.
 * @property init the function that `#pragma init` names; null for the one of the API.
 * @property reserved variables that the compiler must not use, each with the place that asks for it.
 */
internal class Pragmas(val hasInit: Boolean, val init: InitFunction?, val reserved: List<Pair<IntRange, SourceRange>>)

internal class InitFunction(val name: String, val range: SourceRange)

/** The tokens of a program after all directives and macros. */
internal class PreprocessedProgram(val tokens: List<Token>, val pragmas: Pragmas, val macros: Map<String, Macro>)
