package robotran.workshop.programs

import robotran.programs.CompilerLoading
import robotran.workshop.state.CompileStatus
import kotlin.coroutines.cancellation.CancellationException

/** Runs [compile] and returns its result. A bug of the compiler is a result, too: the pupil can still edit the program. */
internal suspend fun resultOf(compile: suspend () -> CompilerLoading): CompileStatus = try {
    when (compile()) {
        CompilerLoading.Success -> CompileStatus.DONE
        is CompilerLoading.Failure -> CompileStatus.NO_COMPILER
    }
} catch (cancelled: CancellationException) {
    throw cancelled
} catch (_: Throwable) {
    CompileStatus.COMPILER_FAILED
}
