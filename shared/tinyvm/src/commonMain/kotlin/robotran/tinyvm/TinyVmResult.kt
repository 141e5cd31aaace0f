package robotran.tinyvm

import robotran.tinyvm.diagnostic.LinkError

/** The result of [linkTinyVm]. */
sealed interface TinyVmResult {
    /** [program] can be loaded into a brick. */
    data class Success(val program: TinyVmProgram) : TinyVmResult

    /** The program cannot run; [refusal] says why. */
    data class Failure(val refusal: LinkError) : TinyVmResult
}
