package robotran.legofirmware.assembly

/** What an assembly text may have. */
object AssemblyLimits {
    /** Max characters of a source. */
    const val SOURCE_CHARACTERS = 1_000_000

    /** Max diagnostics for one source; further mistakes are not reported. */
    const val DIAGNOSTICS = 100
}
