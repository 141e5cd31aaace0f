package robotran.tinyvm

import robotran.tinyvm.diagnostic.LinkError

/** What came of linking classes. */
sealed interface TinyVmResult {
    /** [program] can be loaded into a brick. */
    data class Ready(val program: TinyVmProgram) : TinyVmResult

    /** It cannot run. */
    data class Rejected(val refusal: LinkError) : TinyVmResult
}
