package robotran.nqc.api

import robotran.nqc.config.ParameterLimit

/** What an entry of the API means, in NQC. */
internal sealed interface ApiDefinition {
    /**
     * A function.
     *
     * @property declaration its parameters. `{basic}` and `{random}` in the [body] stand for the sources that a command
     * of the first firmware takes: variables and constants, and in the second case random numbers.
     * @property limits the constants that make sense for each parameter; null for all.
     */
    class Function(val declaration: String, val body: String, val limits: List<ParameterLimit?>) : ApiDefinition

    /** A name that stands for [text]. */
    class Text(val text: String) : ApiDefinition
}
