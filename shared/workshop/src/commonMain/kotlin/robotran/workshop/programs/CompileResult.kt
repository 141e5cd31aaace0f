package robotran.workshop.programs

import robotran.programs.CompilerLoading
import robotran.workshop.state.ProgramReading
import kotlin.coroutines.cancellation.CancellationException

/** Runs [compile] and returns its result. A bug of the compiler is a result, too: the pupil can still edit the program. */
internal suspend fun resultOf(compile: suspend () -> CompilerLoading): ProgramReading = try {
    when (compile()) {
        CompilerLoading.Loaded -> ProgramReading.DONE
        is CompilerLoading.Failed -> ProgramReading.NO_COMPILER
    }
} catch (cancelled: CancellationException) {
    throw cancelled
} catch (_: Throwable) {
    ProgramReading.COMPILER_FAILED
}
